// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>

#include "core/spline/knot_vector.h"

namespace fairing::spline {

inline constexpr int kMaxDegree = 25;          ///< as in OCCT
inline constexpr int kMaxBasisDerivative = 4;  ///< highest derivative basisRow() gives

/// The degree + 1 basis functions that do not vanish at a parameter.
struct BasisRow {
  int first = 0;  ///< index of the first of them
  /// values(k, i): k-th derivative of basis function first + i. No heap: the size is bounded.
  Eigen::Matrix<double,
                Eigen::Dynamic,
                Eigen::Dynamic,
                Eigen::RowMajor,
                kMaxBasisDerivative + 1,
                kMaxDegree + 1>
      values;
};

/// Basis functions and their derivatives up to `order` at t (clamped to the domain). Cost
/// O(degree^2). [PieglTiller1997] algorithm A2.3.
[[nodiscard]] BasisRow basisRow(const KnotVector& knots, double t, int order = 0);

/// Row k holds all basis functions (or their derivative) at parameters[k]: #parameters x #poles.
[[nodiscard]] Eigen::MatrixXd collocationMatrix(const KnotVector& knots,
                                                const std::vector<double>& parameters,
                                                int derivative = 0);

}  // namespace fairing::spline
