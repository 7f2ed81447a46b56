// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/bspline_basis.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/assert.h"

namespace fairing::spline {
namespace {

using Table = std::array<std::array<double, kMaxDegree + 1>, kMaxDegree + 1>;

// Upper triangle (column j): basis functions of degree j; lower triangle: the knot differences they
// divide by.
Table basisTable(const std::vector<double>& knots, int degree, int span, double t) {
  Table table;
  std::array<double, kMaxDegree + 1> left, right;
  const auto at = [&](int i) { return knots[static_cast<std::size_t>(i)]; };
  table[0][0] = 1.0;
  for (int j = 1; j <= degree; ++j) {
    const auto sj = static_cast<std::size_t>(j);
    left[sj] = t - at(span + 1 - j);
    right[sj] = at(span + j) - t;
    double saved = 0.0;
    for (int r = 0; r < j; ++r) {
      const auto sr = static_cast<std::size_t>(r);
      table[sj][sr] = right[sr + 1] + left[sj - sr];
      const double share = table[sr][sj - 1] / table[sj][sr];
      table[sr][sj] = saved + right[sr + 1] * share;
      saved = left[sj - sr] * share;
    }
    table[sj][sj] = saved;
  }
  return table;
}

// Derivatives of basis function r (counted from the first non-vanishing one), [PieglTiller1997]
// eq. 2.9.
void fillDerivatives(const Table& table, int degree, int order, int r, BasisRow& row) {
  std::array<std::array<double, kMaxDegree + 1>, 2> a;
  a[0][0] = 1.0;
  std::size_t current = 0, next = 1;
  const auto ndu = [&](int i, int j) {
    return table[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  for (int k = 1; k <= order; ++k) {
    double sum = 0.0;
    const int rk = r - k, pk = degree - k;
    if (r >= k) {
      a[next][0] = a[current][0] / ndu(pk + 1, rk);
      sum = a[next][0] * ndu(rk, pk);
    }
    const int from = rk >= -1 ? 1 : -rk;
    const int to = r - 1 <= pk ? k - 1 : degree - r;
    for (int j = from; j <= to; ++j) {
      const auto sj = static_cast<std::size_t>(j);
      a[next][sj] = (a[current][sj] - a[current][sj - 1]) / ndu(pk + 1, rk + j);
      sum += a[next][sj] * ndu(rk + j, pk);
    }
    if (r <= pk) {
      const auto sk = static_cast<std::size_t>(k);
      a[next][sk] = -a[current][sk - 1] / ndu(pk + 1, r);
      sum += a[next][sk] * ndu(r, pk);
    }
    row.values(k, r) = sum;
    std::swap(current, next);
  }
}

}  // namespace

BasisRow basisRow(const KnotVector& knots, double t, int order) {
  const int degree = knots.degree();
  FAIRING_ASSERT(degree <= kMaxDegree && order <= kMaxBasisDerivative);
  const double inside = std::clamp(t, knots.first(), knots.last());
  const int span = knots.span(inside);
  const Table table = basisTable(knots.knots(), degree, span, inside);
  BasisRow row;
  row.first = span - degree;
  row.values.setZero(order + 1, degree + 1);
  for (int i = 0; i <= degree; ++i) {
    row.values(0, i) = table[static_cast<std::size_t>(i)][static_cast<std::size_t>(degree)];
    fillDerivatives(table, degree, std::min(order, degree), i, row);
  }
  double factor = degree;
  for (int k = 1; k <= std::min(order, degree); ++k) {
    row.values.row(k) *= factor;
    factor *= degree - k;
  }
  return row;
}

Eigen::MatrixXd collocationMatrix(const KnotVector& knots,
                                  const std::vector<double>& parameters,
                                  int derivative) {
  Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(parameters.size()), knots.poleCount());
  for (Eigen::Index k = 0; k < matrix.rows(); ++k) {
    const BasisRow row = basisRow(knots, parameters[static_cast<std::size_t>(k)], derivative);
    matrix.row(k).segment(row.first, knots.degree() + 1) = row.values.row(derivative);
  }
  return matrix;
}

}  // namespace fairing::spline
