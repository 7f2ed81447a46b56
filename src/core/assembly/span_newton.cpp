// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/span_newton.h"

#include "core/base/assert.h"

// With the basis functions U_i V_j, jet columns (a, b) and (c, d), coordinates x and y:
//   H(i j x, k l y) = sum_p sum_ac U_i^a U_k^c (p) sum_q sum_bd V_j^b V_l^d (q) S_pq(abx, cdy),
// p, q the points along u and v. Of the pairs (a, c) those with a < c stand for both orders and
// those with a = c count half: what is summed is half of H, the other half its transpose.

namespace fairing::assembly {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using shape_energy::DensityHessian;

constexpr auto kJetPairs = spline::jetPairs(false);

// Products of derivatives a and c of all pairs of functions: the second one runs faster.
Eigen::VectorXd products(const spline::BasisRow& row, int a, int c) {
  const Index n = row.values.cols();
  Eigen::VectorXd result(n * n);
  for (Index i = 0; i < n; ++i)
    result.segment(i * n, n) = row.values(a, i) * row.values.row(c).transpose();
  return result;
}

}  // namespace

SpanNewton::SpanNewton(std::span<const spline::GridPoint> u, std::span<const spline::GridPoint> v)
    : countU_(u[0].basis.values.cols()),
      countV_(v[0].basis.values.cols()),
      pointsU_(static_cast<Index>(u.size())),
      pointsV_(static_cast<Index>(v.size())),
      alongU_(countU_ * countU_, pointsU_ * kPairs) {
  for (Index place = 0; place < kPairs; ++place) {
    const spline::JetPairs& orders = kJetPairs[static_cast<std::size_t>(place)];
    for (Index p = 0; p < pointsU_; ++p)
      alongU_.col(p * kPairs + place) =
          products(u[static_cast<std::size_t>(p)].basis, orders.a, orders.c);
    MatrixXd all(countV_ * countV_, pointsV_ * orders.count);
    for (Index q = 0; q < pointsV_; ++q)
      for (Index m = 0; m < orders.count; ++m)
        all.col(q * orders.count + m) =
            products(v[static_cast<std::size_t>(q)].basis, orders.pairs[m].b, orders.pairs[m].d);
    alongV_.push_back(std::move(all));
  }
}

MatrixXd SpanNewton::hessian(const std::vector<DensityHessian>& atPoints) const {
  FAIRING_ASSERT(static_cast<Index>(atPoints.size()) == pointsU_ * pointsV_);
  const Index pairsV = countV_ * countV_, size = 3 * countU_ * countV_;
  MatrixXd inner(pairsV * 9, pointsU_ * kPairs);  // (j, l, x, y) by (p, pair of orders)
  for (Index place = 0; place < kPairs; ++place) {
    const spline::JetPairs& orders = kJetPairs[static_cast<std::size_t>(place)];
    const double share = orders.a == orders.c ? 0.5 : 1.0;
    MatrixXd entries(pointsV_ * orders.count, 9);
    for (Index p = 0; p < pointsU_; ++p) {
      for (Index q = 0; q < pointsV_; ++q)
        for (Index m = 0; m < orders.count; ++m) {
          const auto& at = atPoints[static_cast<std::size_t>(p * pointsV_ + q)];
          const spline::JetPair& columns = orders.pairs[m];
          const Eigen::Matrix3d block =
              share * at.block<3, 3>(3 * columns.first, 3 * columns.second);
          entries.row(q * orders.count + m) =
              Eigen::Map<const Eigen::Matrix<double, 1, 9>>(block.data());
        }
      Eigen::Map<MatrixXd>(inner.col(p * kPairs + place).data(), pairsV, 9).noalias() =
          alongV_[static_cast<std::size_t>(place)] * entries;
    }
  }
  const MatrixXd all = inner * alongU_.transpose();  // (j, l, x, y) by (i, k)
  MatrixXd half(size, size);
  for (Index i = 0; i < countU_; ++i)
    for (Index k = 0; k < countU_; ++k) {
      const auto column = all.col(i * countU_ + k);
      for (Index y = 0; y < 3; ++y)
        for (Index x = 0; x < 3; ++x)
          for (Index j = 0; j < countV_; ++j)
            for (Index l = 0; l < countV_; ++l)
              half(3 * (i * countV_ + j) + x, 3 * (k * countV_ + l) + y) =
                  column[(3 * y + x) * pairsV + j * countV_ + l];
    }
  return half + half.transpose();
}

}  // namespace fairing::assembly
