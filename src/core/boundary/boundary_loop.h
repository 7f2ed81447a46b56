// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/boundary/continuity.h"
#include "core/boundary/departure.h"
#include "core/boundary/ribbon.h"

namespace fairing::boundary {

/// Up to which parameter of a side a continuity is asked for.
struct ContinuityUpTo {
  double t = 1.0;
  Continuity continuity = Continuity::G1;
};

/// One side of the hole: an edge, the face beside it and how the patch is to meet it.
struct BoundarySide {
  int edge = 0;  ///< FreeCAD's EdgeN, for messages and reports
  int face = 0;  ///< FreeCAD's FaceN of the support face, 0 = none
  Continuity continuity = Continuity::G1;
  Ribbon ribbon;
  double length = 0.0;  ///< mm
  double supportDeviation =
      0.0;                  ///< largest distance found between the 3D edge and the support face, mm
  double followedBy = 0.0;  ///< how far followSupports() moved the side towards its face, mm
  /// Where edges that ask for different continuity make one side: ascending, the last one's t is 1.
  /// Empty = `continuity` (the strictest of them) all along.
  std::vector<ContinuityUpTo> stretches;
  Departure departure = Departure::Free;  ///< asked of sides that are tangent
  Leaving leaving = Leaving::Onwards;     ///< what counts as backwards is judged by it

  /// Whether a tangent plane is asked for anywhere, and there is a face that has one.
  [[nodiscard]] bool isTangent() const {
    return continuity != Continuity::G0 && ribbon.hasSupport();
  }
  [[nodiscard]] Continuity continuityAt(double t) const {
    for (const ContinuityUpTo& stretch : stretches)
      if (t < stretch.t) return stretch.continuity;
    return stretches.empty() ? continuity : stretches.back().continuity;
  }
};

/// Ends of neighbouring edges farther apart than this share of the diagonal are an open loop; CAD
/// vertices of real files are up to 1e-4 wide.
inline constexpr double kLargestCornerGap = 5e-4;

/// A patch whose corner is wider than this (degrees) is nearly degenerate there.
inline constexpr double kWidestCorner = 160.0;

/// Where side i ends and side i+1 begins.
struct Corner {
  /// The two do not meet: the ends of an open chain that a strip joins to another one, or of one
  /// closed strip (side_chain.h). Of an open chain `angle` is 0 there.
  bool apart = false;
  /// The two faces beside it meet in an edge, or a chain without faces turns: what spans it may
  /// have a crease from here on (side_chain.h).
  bool crease = false;
  /// The two ask for different continuity (side_chain.h).
  bool changes = false;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double angle = 0.0;  ///< between the two sides, degrees in (0, 180)
  /// The angle the hole has here, degrees in (0, 360): beyond 180 at a re-entrant corner. Without a
  /// support normal on either side it is `angle`.
  double insideAngle = 0.0;
  double normalMismatch =
      0.0;           ///< between the two support normals, degrees; 0 where a side has no support
  double gap = 0.0;  ///< distance between the end of one edge and the start of the next, mm
  /// Difference of the twists the two sides ask for, as a rate of turn of the tangent plane:
  /// degrees over a unit of the side's parameter. 0 where one of the sides is G0.
  double twistMismatch = 0.0;
  /// So little of a corner that nothing need bend for it.
  [[nodiscard]] bool isNearlyStraight() const { return insideAngle > 177.0 && insideAngle < 183.0; }
  [[nodiscard]] bool normalsAgree(double degrees) const { return normalMismatch <= degrees; }
};

/// Positions of sides from a first one up to the one before another.
using SideRange = std::pair<std::size_t, std::size_t>;

/// A closed chain of sides, head to tail: the end of side i is the start of side i+1, the last
/// one's end that of side 0; or several of them; or open chains one after the other (side_chain.h,
/// ring_of_chains.h). Seen against the support normals the hole lies to the left.
struct BoundaryLoop {
  std::vector<BoundarySide> sides;
  std::vector<Corner> corners;  ///< corners[i] is at the end of sides[i]
  double diagonal = 0.0;        ///< largest distance between two points of the sides, mm
  /// Positions of the sides that further chains begin with, ascending; empty = one chain.
  std::vector<std::size_t> further;

  /// The position of the side that starts where another one ends, and of the one that ends where it
  /// starts.
  [[nodiscard]] std::size_t next(std::size_t side) const;
  [[nodiscard]] std::size_t previous(std::size_t side) const;
  /// Whether its chains are open; all of them are, or none.
  [[nodiscard]] bool isOpen() const { return corners.back().apart; }
  /// The chains: the position of the first side, and the one behind the last.
  [[nodiscard]] std::vector<SideRange> chains() const;
  /// FreeCAD's FaceN of the faces beside some of its sides.
  [[nodiscard]] std::set<int> facesBeside(const SideRange& range) const;
};

/// Completes a loop whose sides are given: corners classified, lengths and diagonal measured from
/// the ribbons. `further` as in BoundaryLoop. Fails with LoopNotClosed, EdgeDegenerate, NotFinite
/// or EdgeWithoutFace.
[[nodiscard]] Result<BoundaryLoop> makeLoop(std::vector<BoundarySide> sides,
                                            std::vector<std::size_t> further = {});

/// The same of open chains: where one ends the corner is `apart`. Fails as makeLoop() does.
[[nodiscard]] Result<BoundaryLoop> makeOpenChains(std::vector<BoundarySide> sides,
                                                  std::vector<std::size_t> further);

/// What makeLoop() does without a look at where sides meet: the corners are left out.
[[nodiscard]] Result<BoundaryLoop> measureSides(std::vector<BoundarySide> sides);

/// The corner where one side ends and the next one starts.
[[nodiscard]] Corner cornerBetween(const BoundarySide& before, const BoundarySide& after);

/// LoopNotClosed where two sides that should meet in a corner are too far apart for that.
[[nodiscard]] std::optional<Error> checkMeeting(const BoundarySide& before,
                                                const Corner& corner,
                                                double diagonal);

}  // namespace fairing::boundary
