// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/shape_energy/shape_energy.h"
#include "core/spline/jet_pairs.h"

namespace fairing::assembly {

/// Second derivatives with respect to the control points of one span,
///   sum_q B_q' S_q B_q,   B_q the basis functions' derivatives that make the jet at a point q of
/// the quadrature, S_q a symmetric 27 x 27 matrix,
/// by sums along v first, then along u: some ten times as fast as point by point.
class SpanNewton {
 public:
  /// The points of the quadrature along u and along v in the span.
  SpanNewton(std::span<const spline::GridPoint> u, std::span<const spline::GridPoint> v);

  /// One matrix a point, those of one u after the other. 3 coordinates a control point, those of
  /// one u after the other.
  [[nodiscard]] Eigen::MatrixXd hessian(
      const std::vector<shape_energy::DensityHessian>& atPoints) const;

 private:
  static constexpr int kPairs = spline::kOrderPairs;
  Eigen::Index countU_, countV_, pointsU_, pointsV_;
  // A pair of orders each: (j, l) by (q, pair of jet columns).
  std::vector<Eigen::MatrixXd> alongV_;
  Eigen::MatrixXd alongU_;  // (i, k) by (p, pair of orders)
};

}  // namespace fairing::assembly
