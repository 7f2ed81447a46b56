// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/surface_grid.h"

#include "core/spline/quadrature.h"

namespace fairing::spline {

using Eigen::Index;
using Eigen::MatrixXd;

GridLine::GridLine(const KnotVector& knots, const QuadratureRule& rule)
    : perSpan(static_cast<std::size_t>(rule.points)) {
  for (const auto& q : quadrature(rule, knots))
    points.push_back({q.weight, basisRow(knots, q.parameter, 3)});
  for (std::size_t a = 0; a < values.size(); ++a) {
    values[a].setZero(static_cast<Index>(points.size()), knots.poleCount());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const BasisRow& row = points[k].basis;
      values[a].row(static_cast<Index>(k)).segment(row.first, row.values.cols()) =
          row.values.row(static_cast<Index>(a));
    }
  }
}

// One coordinate's derivative (a, b) is  U_a P V_b'.
std::vector<ThirdOrderJet> gridJets(const BsplineSurface& surface,
                                    const GridLine& u,
                                    const GridLine& v) {
  using Stride = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
  const Index nu = surface.u.poleCount(), nv = surface.v.poleCount();
  std::vector<ThirdOrderJet> jets(u.points.size() * v.points.size());
  std::array<MatrixXd, 4> alongV;
  for (Index c = 0; c < 3; ++c) {
    const Eigen::Map<const MatrixXd, 0, Stride> poles(
        surface.poles.data() + c, nu, nv, Stride(3, 3 * nv));
    for (std::size_t b = 0; b < alongV.size(); ++b)
      alongV[b].noalias() = v.values[b] * poles.transpose();
    for (Index k = 0; k < 9; ++k) {
      const MatrixXd derivative = alongV[static_cast<std::size_t>(kJetOrders[k][1])] *
                                  u.values[static_cast<std::size_t>(kJetOrders[k][0])].transpose();
      for (std::size_t q = 0; q < jets.size(); ++q) jets[q](c, k) = derivative.data()[q];
    }
  }
  return jets;
}

}  // namespace fairing::spline
