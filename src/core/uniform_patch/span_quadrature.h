// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

namespace fairing::uniform_patch {

/// The four cubic B-splines on uniform knots that do not vanish on a span, at 0 <= t <= 1 of it:
/// (k, i) is the k-th derivative of the i-th. [Kiciak2011] section 2.
[[nodiscard]] Eigen::Matrix4d cubicRows(double t);

/// Where a parameter t lies on a direction's knots: the span 3 + span <= t <= 4 + span, and how far
/// into it. Parameters beyond the domain count as of the span next to them.
struct SpanPlace {
  SpanPlace(double t, int spans);
  int span;
  double local;
};

/// Gauss-Legendre with n x n points on a span. The knots are uniform, so all spans share it.
struct SpanQuadrature {
  explicit SpanQuadrature(int pointsPerDirection);

  [[nodiscard]] int index(int p, int q) const { return p * n + q; }
  [[nodiscard]] double weight(int p, int q) const {
    return weights[std::size_t(p)] * weights[std::size_t(q)];
  }

  int n;
  std::vector<Eigen::Matrix4d> rows;  ///< [p]: cubicRows at the p-th point of one direction
  std::vector<double> weights;        ///< of the points of one direction
  /// Row 9 * index(p, q) + k: the derivative that is the k-th of a third order jet
  /// (spline::kJetOrders), of the 16 basis functions; column 4 * i + j.
  Eigen::MatrixXd jets;
};

}  // namespace fairing::uniform_patch
