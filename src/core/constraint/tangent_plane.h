// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/boundary/boundary_loop.h"
#include "core/constraint/constraint_set.h"

namespace fairing::constraint {

/// A patch edge that follows a side, with what is known of it: everything along the border's
/// direction.
struct ConstrainedEdge {
  /// What an end is: a corner or a seam's end, which have blocks of their own; the end of a seam
  /// that is a crease; nothing at all; or one and the same place as the other end.
  enum class End { Held, Crease, Free, Closed };
  const boundary::BoundarySide* side = nullptr;
  const layout::SideUse* use = nullptr;
  spline::KnotVector knots;
  std::vector<int> outer, inner;  ///< point numbers of the row on the edge and of the next one
  End start = End::Held, end = End::Held;

  [[nodiscard]] bool isTangent() const { return side->isTangent(); }
  [[nodiscard]] bool isTangentAt(double sideParameter) const {
    return isTangent() && side->continuityAt(sideParameter) != Continuity::G0;
  }
  /// The side's parameter at a parameter of the patch.
  [[nodiscard]] double sideParameter(double s) const {
    return (s - knots.first()) / (knots.last() - knots.first());
  }
  /// d(side parameter) / d(patch parameter).
  [[nodiscard]] double rate() const { return 1.0 / (knots.last() - knots.first()); }
};

/// The twist of the corner where `before` ends and `after` starts, from the sides that are tangent
/// there.
///   R_v . n = 0 along `before` gives, differentiated, R_uv . n = -R_v . n_u; `after` gives R_uv .
///   n = -R_u . n_v.
/// Where the two differ their mean is taken: each side then bears half of the error.
[[nodiscard]] std::optional<solver::ConstraintBlock> cornerTwist(const ConstrainedEdge& before,
                                                                 const ConstrainedEdge& after);

/// The end of a seam on the loop, where `before` (of one patch) ends and `after` (of the next one)
/// starts: the seam leaves in the tangent plane, and R_v . n = 0 holds with its derivative on
/// either side. Normals that nearly agree count as their mean, and where the loop goes straight on,
/// their derivatives, too: the rows are dependent then to the last bit.
[[nodiscard]] std::optional<solver::ConstraintBlock> splitTangency(const ConstrainedEdge& before,
                                                                   const ConstrainedEdge& after,
                                                                   const boundary::Corner& corner);

/// A place at which an edge is collocated, and the pole next to it.
struct Collocation {
  int pole = 0;
  double s = 0.0;  ///< parameter of the patch
};

/// The Greville abscissae of an edge's poles. Left out are the two next to a held end, where R_v .
/// n has a double zero already; a closed edge has those of the periodic spline it is.
[[nodiscard]] std::vector<Collocation> collocation(const ConstrainedEdge& edge);

/// R_v . n = 0 along an edge, collocated; where the side asks for a direction d of departure in the
/// tangent plane, R_v . (n x d) = 0, too.
/// Where the support has no normal nothing is asked. Fails with SupportNormalSingular where it has
/// none all along.
[[nodiscard]] Result<solver::ConstraintBlock> tangentRows(const ConstrainedEdge& edge);

}  // namespace fairing::constraint
