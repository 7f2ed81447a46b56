// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <array>

#include "core/spline/bspline_basis.h"
#include "core/spline/bspline_curve.h"
#include "core/spline/knot_vector.h"

namespace fairing::spline {

/// Position and partial derivatives up to order two.
struct SurfaceJet {
  Eigen::Vector3d point, u, v, uu, uv, vv;
  /// u x v, not of unit length.
  [[nodiscard]] Eigen::Vector3d normalVector() const;
};

/// Partial derivatives, one a column; no heap.
using Partials = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 25>;

/// R(u, v) = sum_ij B_i(u) B_j(v) pole(i, j) on clamped knots; a Bezier patch is the one-span case.
struct BsplineSurface {
  KnotVector u, v;
  Poles poles;  ///< pole (i, j) is row i * v.poleCount() + j

  [[nodiscard]] int index(int i, int j) const { return i * v.poleCount() + j; }
  [[nodiscard]] Eigen::Vector3d pole(int i, int j) const { return poles.row(index(i, j)); }
  /// d^(a+b) R / du^a dv^b.
  [[nodiscard]] Eigen::Vector3d evaluate(double s, double t, int a = 0, int b = 0) const;
  [[nodiscard]] SurfaceJet jet(double s, double t) const;
  /// All partial derivatives up to `order` (at most 4) along each direction: column a * (order + 1)
  /// + b holds d^(a+b) R / du^a dv^b.
  [[nodiscard]] Partials derivatives(double s, double t, int order) const;
};

[[nodiscard]] BsplineSurface refinedTo(const BsplineSurface& surface,
                                       const KnotVector& u,
                                       const KnotVector& v);
[[nodiscard]] BsplineSurface raiseDegree(const BsplineSurface& surface, int timesU, int timesV);
[[nodiscard]] BsplineSurface transposed(const BsplineSurface& surface);

}  // namespace fairing::spline
