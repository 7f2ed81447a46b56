// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/assemble_energy.h"

#include <algorithm>
#include <map>

#include "core/energy/gram.h"

namespace fairing::assembly {
namespace {

using Eigen::MatrixXd;

// Gram matrices of one direction, each computed once.
class Grams {
 public:
  explicit Grams(const spline::KnotVector& knots) : knots_(knots) {}
  const MatrixXd& operator()(int a, int b) {
    const auto found = known_.find({a, b});
    if (found != known_.end()) return found->second;
    return known_.emplace(std::pair{a, b}, energy::gramMatrix(knots_, a, b)).first->second;
  }

 private:
  const spline::KnotVector& knots_;
  std::map<std::pair<int, int>, MatrixXd> known_;
};

// One term as a product along u times one along v; a mixed term is symmetrised.
struct Product {
  MatrixXd u, v;
};

std::vector<Product> products(const layout::LayoutPatch& patch, const energy::EnergyTerms& terms) {
  Grams gramU(patch.u), gramV(patch.v);
  std::vector<Product> result;
  for (const energy::EnergyTerm& term : terms) {
    const auto [weight, a, b] = term;
    if (a.u == b.u && a.v == b.v) {
      result.push_back({weight * gramU(a.u, b.u), gramV(a.v, b.v)});
      continue;
    }
    result.push_back({0.5 * weight * gramU(a.u, b.u), gramV(a.v, b.v)});
    result.push_back({0.5 * weight * gramU(b.u, a.u), gramV(b.v, a.v)});
  }
  return result;
}

}  // namespace

solver::Sparse assembleEnergy(const layout::PatchLayout& layout, const energy::EnergyTerms& terms) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const layout::LayoutPatch& patch : layout.patches) {
    const std::vector<Product> all = products(patch, terms);
    const int nu = patch.u.poleCount(), nv = patch.v.poleCount();
    const int p = patch.u.degree(), q = patch.v.degree();
    const auto point = [&](int i, int j) {
      return patch.points[static_cast<std::size_t>(i * nv + j)];
    };
    for (int i = 0; i < nu; ++i)
      for (int k = std::max(0, i - p); k <= std::min(nu - 1, i + p); ++k)
        for (int j = 0; j < nv; ++j)
          for (int l = std::max(0, j - q); l <= std::min(nv - 1, j + q); ++l) {
            double sum = 0.0;
            for (const Product& product : all) sum += product.u(i, k) * product.v(j, l);
            entries.emplace_back(point(i, j), point(k, l), sum);
          }
  }
  solver::Sparse matrix(layout.pointCount, layout.pointCount);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace fairing::assembly
