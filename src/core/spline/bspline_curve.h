// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>

#include "core/spline/knot_vector.h"

namespace fairing::spline {

using Poles =
    Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;  ///< one control point a row, mm

/// C(t) = sum_i B_i(t) poles.row(i), a polynomial clamped B-spline; a Bezier curve is the one-span
/// case.
struct BsplineCurve {
  KnotVector knots;
  Poles poles;

  /// The derivative of the given order, 0 = position. Cost O(degree^2).
  [[nodiscard]] Eigen::Vector3d evaluate(double t, int derivative = 0) const;
};

[[nodiscard]] BsplineCurve reversed(const BsplineCurve& curve);
/// The same curve with one more knot at t (Boehm).
[[nodiscard]] BsplineCurve insertKnot(const BsplineCurve& curve, double t);
/// The same curve on finer knots of the same degree that contain its own.
[[nodiscard]] BsplineCurve refinedTo(const BsplineCurve& curve, const KnotVector& finer);
/// The same curve with its degree raised by `times`.
[[nodiscard]] BsplineCurve raiseDegree(const BsplineCurve& curve, int times);
/// The stretch [from, to] of the curve's domain, from < to, as a curve over [0, 1].
[[nodiscard]] BsplineCurve stretchOf(const BsplineCurve& curve, double from, double to);

}  // namespace fairing::spline
