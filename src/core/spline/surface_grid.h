// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "core/spline/bspline_surface.h"
#include "core/spline/fundamental_forms.h"
#include "core/spline/quadrature.h"

namespace fairing::spline {

/// Derivatives (a, b) along (u, v) in the order of the columns of a ThirdOrderJet.
inline constexpr int kJetOrders[9][2] = {
    {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}};

/// A quadrature point of one direction with its basis functions, derivatives up to order 3.
struct GridPoint {
  double weight;
  BasisRow basis;
};

/// One direction's points of a quadrature, `perSpan` of every span one after the other, evaluated
/// once for the whole grid.
struct GridLine {
  GridLine(const KnotVector& knots, const QuadratureRule& rule);

  std::size_t perSpan;
  std::vector<GridPoint> points;
  std::array<Eigen::MatrixXd, 4> values;  ///< [a](k, i): a-th derivative of function i at point k
};

/// The surface's jet at every point of a grid, those of one u after the other.
[[nodiscard]] std::vector<ThirdOrderJet> gridJets(const BsplineSurface& surface,
                                                  const GridLine& u,
                                                  const GridLine& v);

}  // namespace fairing::spline
