// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/boundary/boundary_loop.h"
#include "core/layout/layout_kind.h"
#include "core/spline/bspline_curve.h"
#include "core/spline/knot_vector.h"

namespace fairing::layout {

// The four edges of a patch, in the order and direction of its border:
//
//        North (u falls)
//     +------<------+
//     |             |
//  W  v             ^  East (v rises)
//     |             |
//     +------>------+
//        South (u rises)
enum class PatchEdge { South, East, North, West };

/// The stretch [from, to] of a side's parameter that a patch edge covers, along the border's
/// direction.
struct SideUse {
  int side = 0;
  double from = 0.0, to = 1.0;
  /// The stretch as a curve on the patch's knots in the border's direction (domain as wide as the
  /// patch's).
  spline::BsplineCurve curve;
};

/// One patch: its knots, over [0, width] x [0, height], domains that have the proportions of the
/// hole and an area of about 1, so that energies neither depend on the model's size nor on which
/// direction is called u.
struct LayoutPatch {
  spline::KnotVector u, v;
  std::array<std::optional<SideUse>, 4> edges;  ///< by PatchEdge; empty = a seam
  std::vector<int> points;  ///< number of the unknown behind pole (i, j), at i * v.poleCount() + j
};

/// How patches span a loop: who covers what, on which knots, with which unknowns.
struct PatchLayout {
  LayoutKind kind = LayoutKind::Quad;
  std::vector<LayoutPatch> patches;
  int pointCount = 0;  ///< unknown control points, shared ones counted once
  /// Largest distance between a side and the curve that stands for it, mm; 0 where taken over
  /// exactly.
  double curveDeviation = 0.0;
};

/// The control points along a patch edge, from its start to its end in the border's direction: row
/// 0 on the edge, row 1 the next one inside. Entries are point numbers.
[[nodiscard]] std::vector<int> edgePoints(const LayoutPatch& patch, PatchEdge edge, int row);

/// The knots along a patch edge in the border's direction.
[[nodiscard]] spline::KnotVector edgeKnots(const LayoutPatch& patch, PatchEdge edge);

}  // namespace fairing::layout
