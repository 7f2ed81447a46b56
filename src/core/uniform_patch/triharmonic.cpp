// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/triharmonic.h"

#include "core/uniform_patch/span_quadrature.h"

namespace fairing::uniform_patch {
namespace {

using Element = Eigen::Matrix<double, 16, 16>;

// The form of one span, the same for all: jet columns 5 to 8 are R_uuu, R_uuv, R_uvv, R_vvv.
Element elementStiffness() {
  const SpanQuadrature quadrature(4);  // exact for the squares of cubics
  Element element = Element::Zero();
  for (int p = 0; p < quadrature.n; ++p)
    for (int q = 0; q < quadrature.n; ++q) {
      const auto jet = quadrature.jets.middleRows<9>(9 * quadrature.index(p, q));
      const double weight = quadrature.weights[std::size_t(p)] * quadrature.weights[std::size_t(q)];
      for (const auto& [x, y] : {std::pair(5, 7), std::pair(6, 8)}) {
        const Eigen::RowVectorXd row = jet.row(x) + jet.row(y);
        element += weight * row.transpose() * row;
      }
    }
  return element;
}

// Half the slopes of T.
spline::Poles slopesOf(const ControlNet& net) {
  const Element element = elementStiffness();
  spline::Poles slopes = spline::Poles::Zero(net.points.rows(), 3);
  forEachSpan(net, [&](const std::array<int, 16>& poles) {
    const Eigen::Matrix<double, 16, 3> own = element * net.points(poles, Eigen::all);
    for (std::size_t k = 0; k < 16; ++k) slopes.row(poles[k]) += own.row(Eigen::Index(k));
  });
  return slopes;
}

}  // namespace

double triharmonicEnergy(const ControlNet& net) {
  return net.points.cwiseProduct(slopesOf(net)).sum();
}

solver::BandMatrix triharmonicStiffness(const ControlNet& net, const FreePoints& free) {
  const Element element = elementStiffness();
  solver::BandMatrix stiffness(free.count, free.couplingWidth(net));
  forEachSpan(net, [&](const std::array<int, 16>& poles) {
    for (std::size_t k = 0; k < 16; ++k)
      for (const FreePoints::Term& x : free.terms[std::size_t(poles[k])])
        for (std::size_t l = 0; l < 16; ++l)
          for (const FreePoints::Term& y : free.terms[std::size_t(poles[l])])
            if (x.free >= y.free)
              stiffness.at(x.free, y.free) +=
                  x.factor * y.factor * element(Eigen::Index(k), Eigen::Index(l));
  });
  return stiffness;
}

Result<ControlNet> triharmonicNet(const ConstrainedNet& given) {
  ControlNet net = given.net;
  if (given.free.count == 0) return net;
  const auto factor = solver::BandCholesky::factor(triharmonicStiffness(given.net, given.free));
  if (!factor) return fail({.code = ErrorCode::SystemSingular});
  // The second round takes back what the first one lost to rounding.
  for (int round = 0; round < 2; ++round)
    net.points -= given.free.spread(factor->solve(given.free.gather(slopesOf(net))));
  if (!net.points.allFinite()) return fail({.code = ErrorCode::NotFinite});
  return net;
}

}  // namespace fairing::uniform_patch
