// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/height_jet.h"

#include "core/base/assert.h"

namespace fairing::height_field {
namespace {

// Orders along u and v of the jet's entries.
constexpr int kOrders[kJetSize][2] = {
    {0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}};

}  // namespace

JetBasis jetBasis(const spline::BasisRow& u, const spline::BasisRow& v) {
  const Eigen::Index nu = u.values.cols(), nv = v.values.cols();
  FAIRING_ASSERT(nu * nv <= kMostBasis);
  JetBasis basis{u.first, v.first, {}};
  basis.values.resize(kJetSize, nu * nv);
  for (Eigen::Index i = 0; i < nu; ++i)
    for (Eigen::Index j = 0; j < nv; ++j)
      for (int k = 0; k < kJetSize; ++k)
        basis.values(k, i * nv + j) = u.values(kOrders[k][0], i) * v.values(kOrders[k][1], j);
  return basis;
}

JetBasis jetBasis(const spline::KnotVector& u, const spline::KnotVector& v, double s, double t) {
  return jetBasis(spline::basisRow(u, s, 3), spline::basisRow(v, t, 3));
}

Jet Heights::jet(double s, double t) const {
  return jet(jetBasis(u, v, s, t));
}

Jet Heights::jet(const JetBasis& at) const {
  const int nv = v.degree() + 1;
  Jet sum = Jet::Zero();
  for (int i = 0; i <= u.degree(); ++i)
    sum += at.values.middleCols(i * nv, nv) *
           poles.segment((at.firstU + i) * v.poleCount() + at.firstV, nv);
  return sum;
}

}  // namespace fairing::height_field
