// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/gram.h"

#include <algorithm>

#include "core/spline/bspline_basis.h"
#include "core/spline/quadrature.h"

namespace fairing::energy {

Eigen::MatrixXd gramMatrix(const spline::KnotVector& knots, int a, int b) {
  const int n = knots.poleCount(), width = knots.degree() + 1;
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(n, n);
  for (const spline::QuadraturePoint& q : spline::gaussLegendre(width, knots)) {
    const spline::BasisRow row = spline::basisRow(knots, q.parameter, std::max(a, b));
    gram.block(row.first, row.first, width, width).noalias() +=
        (q.weight * row.values.row(a)).transpose() * row.values.row(b);
  }
  return gram;
}

}  // namespace fairing::energy
