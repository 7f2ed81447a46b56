// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>

#include "core/spline/knot_vector.h"

namespace fairing::energy {

/// G_ij = integral of B_i^(a) B_j^(b) over the knots' domain, exact (Gauss-Legendre with degree + 1
/// points a span). #poles x #poles, banded with half width = degree.
[[nodiscard]] Eigen::MatrixXd gramMatrix(const spline::KnotVector& knots, int a, int b);

}  // namespace fairing::energy
