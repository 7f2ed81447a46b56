// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/boundary/boundary_loop.h"
#include "core/layout/layout_kind.h"
#include "core/layout/quad_mesh.h"
#include "core/spline/bspline_curve.h"
#include "core/spline/knot_vector.h"

namespace fairing::layout {

/// The side of the loop that a patch edge covers.
struct SideUse {
  int side = 0;
  /// The side as a curve on the patch's knots in the border's direction (domain as wide as the
  /// patch's).
  spline::BsplineCurve curve;
};

/// One patch: its knots, over [0, width] x [0, height], domains that have the proportions of the
/// hole, all patches together an area of about 1, so that energies neither depend on the model's
/// size nor on which direction is called u.
struct LayoutPatch {
  spline::KnotVector u, v;
  std::array<std::optional<SideUse>, 4> edges;  ///< by PatchEdge; empty = a seam
  std::vector<int> points;  ///< number of the unknown behind pole (i, j), at i * v.poleCount() + j
};

/// How two patches leave one end of their seam. Derivatives are with respect to parameters that run
/// from 0 to 1 over a patch: across the seam into the first patch D1, into the second D2, along it
/// R_t. Their tangent planes agree where
///   first * D1 + second * D2 = along * R_t.
struct SeamFrame {
  double first = 1.0, second = 1.0, along = 0.0;
};

/// Two patches that share an edge. It runs in the border direction of the first.
struct Seam {
  int first = 0, second = 0;
  PatchEdge firstEdge = PatchEdge::South, secondEdge = PatchEdge::South;
  std::array<int, 2> vertices{};           ///< of the mesh, at the start and at the end
  std::array<char, 2> inside{};            ///< whether that vertex lies inside the hole
  std::array<SeamFrame, 2> frames;         ///< at the start and at the end
  bool crease = false;                     ///< the patches meet in position only
  Continuity continuity = Continuity::G1;  ///< else this: G1 or G2

  /// The frame at t in [0, 1]: `along` as start (1 - t)^2 + end t^2; `first` and `second` linear,
  /// but level at ends inside. There the twists round the vertex obey a cyclic system, which is
  /// singular for an even number of seams: slopes of theirs, which nothing balances where `along`
  /// is small, would make the tangents vanish.
  [[nodiscard]] SeamFrame frame(double t) const;
  /// Its derivative.
  [[nodiscard]] SeamFrame frameDerivative(double t) const;
};

/// How patches span a loop: who covers what, on which knots, with which unknowns.
struct PatchLayout {
  LayoutKind kind = LayoutKind::Quad;
  std::vector<LayoutPatch> patches;
  std::vector<Seam> seams;
  /// The only patch closes upon itself, its curvature included: its West edge is its East edge.
  bool closed = false;
  Strips strips;
  std::vector<spline::KnotVector> stripKnots;  ///< over [0, 1]
  int pointCount = 0;                          ///< unknown control points, shared ones counted once
  /// Largest distance between a side and the curve that stands for it, mm; 0 where taken over
  /// exactly.
  double curveDeviation = 0.0;
};

/// The control points along a patch edge, from its start to its end in the border's direction: row
/// 0 on the edge, row 1 the next one inside. Entries are point numbers.
[[nodiscard]] std::vector<int> edgePoints(const LayoutPatch& patch, PatchEdge edge, int row);

/// Where these stand in LayoutPatch::points.
[[nodiscard]] std::vector<std::size_t> edgePlaces(const LayoutPatch& patch,
                                                  PatchEdge edge,
                                                  int row);

/// The knots along a patch edge in the border's direction.
[[nodiscard]] spline::KnotVector edgeKnots(const LayoutPatch& patch, PatchEdge edge);

/// The derivative across a patch edge, with respect to a parameter that runs from 0 to 1 over the
/// patch, is the difference of rows 1 and 0 divided by this.
[[nodiscard]] double crossStep(const LayoutPatch& patch, PatchEdge edge);

}  // namespace fairing::layout
