// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/spline/knot_vector.h"

namespace fairing::spline {

struct QuadraturePoint {
  double parameter;
  double weight;
};

/// Gauss-Legendre on [a, b] with n >= 1 points: exact for polynomials of degree 2n - 1.
[[nodiscard]] std::vector<QuadraturePoint> gaussLegendre(int n, double a, double b);

/// Gauss-Legendre with n points on every span of the knots.
[[nodiscard]] std::vector<QuadraturePoint> gaussLegendre(int n, const KnotVector& knots);

}  // namespace fairing::spline
