// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/hessian_product.h"

namespace fairing::uniform_patch {
namespace {

constexpr auto kJetPairs = spline::jetPairs(true);

}  // namespace

HessianBasis::HessianBasis(const SpanQuadrature& quadrature)
    : points(quadrature.n), u(16, quadrature.n * kPairs) {
  for (std::size_t place = 0; place < kPairs; ++place) {
    const spline::JetPairs& orders = kJetPairs[place];
    v[place].resize(16, points * orders.count);
    for (int q = 0; q < points; ++q) {
      const Eigen::Matrix4d& rows = quadrature.rows[std::size_t(q)];
      const double weight = quadrature.weights[std::size_t(q)];
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
          u(4 * i + j, q * kPairs + int(place)) = weight * rows(orders.a, i) * rows(orders.c, j);
          for (int m = 0; m < orders.count; ++m) {
            const auto& [b, d, k, l] = orders.pairs[m];
            // a pair stands for both its orders, see HessianProduct::at()
            const double share = k == l ? 0.5 * weight : weight;
            v[place](4 * i + j, q * orders.count + m) = share * rows(b, i) * rows(d, j);
          }
        }
    }
  }
}

HessianProduct::HessianProduct(const HessianBasis& basis)
    : basis_(&basis), lines_(basis.u.cols(), 16 * 9 * kLanes), sum_(16, 16 * 9 * kLanes) {
  for (std::size_t place = 0; place < line_.size(); ++place)
    line_[place].resize(basis.v[place].cols(), 9 * kLanes);
}

void HessianProduct::set(int q, const std::array<Lanes, 405>& hessian) {
  for (std::size_t place = 0; place < line_.size(); ++place) {
    const spline::JetPairs& orders = kJetPairs[place];
    for (int m = 0; m < orders.count; ++m) {
      const int k = orders.pairs[m].first, l = orders.pairs[m].second;
      const Lanes* block = &hessian[std::size_t(
          9 * BlendingDerivatives<Lanes>::blockIndex(std::max(k, l), std::min(k, l)))];
      double* to = line_[place].row(q * orders.count + m).data();
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d, to += kLanes)
          Eigen::Map<Lanes>{to} = k >= l ? block[3 * c + d] : block[3 * d + c];
    }
  }
}

void HessianProduct::finishLine(int p) {
  for (std::size_t place = 0; place < line_.size(); ++place)
    Eigen::Map<RowMajor>(lines_.row(p * HessianBasis::kPairs + int(place)).data(), 16, 9 * kLanes)
        .noalias() = basis_->v[place] * line_[place];
}

void HessianProduct::finish() {
  sum_.noalias() = basis_->u * lines_;
}

}  // namespace fairing::uniform_patch
