// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/spline/bspline_surface.h"

namespace fairing::spline {

/// A tensor-product Bezier patch over the unit square: R(u, v) = sum_ij B_i^n(u) B_j^m(v) P_ij,
/// [WuYang2015] section 2.
struct BezierPatch {
  int degreeU = 0, degreeV = 0;
  Poles poles;  ///< P_ij is row i * (degreeV + 1) + j

  /// Position, by de Casteljau's algorithm.
  [[nodiscard]] Eigen::Vector3d evaluate(double u, double v) const;
};

/// The patch as a one-span B-spline surface over the unit square. Exact.
[[nodiscard]] BsplineSurface toBspline(const BezierPatch& patch);

/// A span of a B-spline surface: its Bezier patch and the stretch of the surface's parameters that
/// it covers.
struct BezierSpan {
  BezierPatch patch;
  double u0, u1, v0, v1;
};

/// All spans of a surface, u slowest. Exact up to rounding: every knot is inserted to full
/// multiplicity.
[[nodiscard]] std::vector<BezierSpan> bezierSpans(const BsplineSurface& surface);

}  // namespace fairing::spline
