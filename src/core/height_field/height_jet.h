// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>

#include "core/spline/bspline_basis.h"
#include "core/spline/knot_vector.h"

namespace fairing::height_field {

/// The partial derivatives of a height h(u, v) up to order three:
/// h, h_u, h_v, h_uu, h_uv, h_vv, h_uuu, h_uuv, h_uvv, h_vvv.
inline constexpr int kJetSize = 10;
using Jet = Eigen::Matrix<double, kJetSize, 1>;
enum JetIndex { H, Hu, Hv, Huu, Huv, Hvv, Huuu, Huuv, Huvv, Hvvv };

/// A linear form on the jet: sum of coefficients times partial derivatives.
using JetForm = Eigen::Matrix<double, kJetSize, 1>;

inline constexpr int kMostBasis = 100;  ///< of degree 9 both ways

/// The basis functions that do not vanish at a place, (i, j) in column i * (degree of v + 1) + j,
/// their partial derivatives in the rows; no heap.
struct JetBasis {
  int firstU = 0, firstV = 0;
  Eigen::Matrix<double, kJetSize, Eigen::Dynamic, Eigen::ColMajor, kJetSize, kMostBasis> values;
};

/// A height as a tensor-product B-spline.
struct Heights {
  spline::KnotVector u, v;
  Eigen::VectorXd poles;  ///< (i, j) is row i * v.poleCount() + j

  [[nodiscard]] Jet jet(double s, double t) const;
  [[nodiscard]] Jet jet(const JetBasis& at) const;
};

/// From rows that hold derivatives up to order three.
[[nodiscard]] JetBasis jetBasis(const spline::BasisRow& u, const spline::BasisRow& v);
[[nodiscard]] JetBasis jetBasis(const spline::KnotVector& u,
                                const spline::KnotVector& v,
                                double s,
                                double t);

}  // namespace fairing::height_field
