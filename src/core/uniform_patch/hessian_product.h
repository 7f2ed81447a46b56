// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/spline/jet_pairs.h"
#include "core/uniform_patch/blending_integrand.h"
#include "core/uniform_patch/span_quadrature.h"

namespace fairing::uniform_patch {

/// Products of two basis functions' derivatives at the quadrature points, weighted: what turns the
/// second derivatives on the jets of a span's points into those on its control points. The basis
/// functions are products of one of u and one of v, so the sum over the points is taken along v
/// first and then along u, each a product of matrices.
///
/// Derivatives with respect to (a, b) along (u, v) are sorted by a; a pair of orders (a, a'),
/// a <= a', has several pairs of orders along v.
struct HessianBasis {
  static constexpr int kPairs = spline::kOrderPairs;
  explicit HessianBasis(const SpanQuadrature& quadrature);

  int points;                             ///< of one direction
  std::array<Eigen::MatrixXd, kPairs> v;  ///< 16 pairs of functions x (points, pairs of orders)
  Eigen::MatrixXd u;                      ///< 16 pairs of functions x (points, kPairs)
};

/// B' h B summed over the points of kLanes spans, h the second derivatives on the jets.
class HessianProduct {
 public:
  explicit HessianProduct(const HessianBasis& basis);

  /// Second derivatives at the q-th point along v of the line that is worked on.
  void set(int q, const std::array<Lanes, 405>& hessian);
  /// Takes the line at the p-th point along u in.
  void finishLine(int p);
  /// All lines are in.
  void finish();
  /// The second derivative with respect to coordinate c of control point k = 4 * i + j and
  /// coordinate d of control point l, of the span in a lane.
  [[nodiscard]] double at(int k, int l, int c, int d, int lane) const {
    return half(k, l, c, d, lane) + half(l, k, d, c, lane);
  }

 private:
  [[nodiscard]] double half(int k, int l, int c, int d, int lane) const {
    return sum_(4 * (k / 4) + l / 4, ((4 * (k % 4) + l % 4) * 9 + 3 * c + d) * kLanes + lane);
  }

  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const HessianBasis* basis_;
  std::array<RowMajor, HessianBasis::kPairs> line_;  // (q, pair of orders) x (c, d, lane)
  RowMajor lines_;                                   // (p, pair) x (pair of functions, c, d, lane)
  RowMajor sum_;                                     // pair of functions x (as in lines_)
};

}  // namespace fairing::uniform_patch
