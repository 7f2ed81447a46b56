// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/free_matrix.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"

// T'HT = sum_e T_e' H_e T_e,   T_e the rows of T of the element's coordinates without the columns
// that vanish there.

namespace fairing::solver {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Columns of `left` summed by the columns of `right`: left * right.
MatrixXd timesSparse(const MatrixXd& left, const Sparse& right) {
  MatrixXd result = MatrixXd::Zero(left.rows(), right.cols());
  for (int c = 0; c < right.outerSize(); ++c)
    for (Sparse::InnerIterator it(right, c); it; ++it)
      result.col(c) += it.value() * left.col(it.row());
  return result;
}

void sortOnce(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

// A matrix of noughts in the rows of each column, which come in any order and more than once.
Sparse noughts(std::vector<std::vector<int>> columns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    sortOnce(columns[c]);
    for (const int row : columns[c]) entries.emplace_back(row, static_cast<int>(c), 0.0);
  }
  Sparse result(static_cast<Index>(columns.size()), static_cast<Index>(columns.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// Adds a dense matrix of some unknowns, ascending, to entries that are there.
void addTo(Sparse& matrix, const std::vector<int>& unknowns, const MatrixXd& entries) {
  for (std::size_t c = 0; c < unknowns.size(); ++c) {
    Sparse::InnerIterator it(matrix, unknowns[c]);
    for (std::size_t r = 0; r < unknowns.size(); ++r) {
      while (it.row() < unknowns[r]) ++it;
      it.valueRef() += entries(static_cast<Index>(r), static_cast<Index>(c));
    }
  }
}

}  // namespace

FreeMatrix::FreeMatrix(const Sparse& freedom, const std::vector<std::vector<int>>& elements) {
  const RowMajor rows = freedom;
  std::vector<std::vector<int>> reached(static_cast<std::size_t>(freedom.cols()));
  for (const std::vector<int>& points : elements) {
    elements_.push_back(elementOf(rows, points));
    const std::vector<int>& unknowns = elements_.back().unknowns;
    for (const int unknown : unknowns) {
      auto& column = reached[static_cast<std::size_t>(unknown)];
      column.insert(column.end(), unknowns.begin(), unknowns.end());
    }
  }
  pattern_ = noughts(std::move(reached));
}

FreeMatrix::Element FreeMatrix::elementOf(const RowMajor& rows, const std::vector<int>& points) {
  Element element;
  std::vector<Eigen::Triplet<double>> entries;  // in the columns of T
  for (std::size_t k = 0; k < 3 * points.size(); ++k)
    for (RowMajor::InnerIterator it(rows, 3 * points[k / 3] + static_cast<int>(k % 3)); it; ++it) {
      entries.emplace_back(static_cast<int>(k), static_cast<int>(it.col()), it.value());
      element.unknowns.push_back(static_cast<int>(it.col()));
    }
  sortOnce(element.unknowns);
  const auto& unknowns = element.unknowns;
  for (auto& entry : entries) {
    const auto column = std::lower_bound(unknowns.begin(), unknowns.end(), entry.col());
    entry = {entry.row(), static_cast<int>(column - unknowns.begin()), entry.value()};
  }
  element.basis.resize(3 * static_cast<Index>(points.size()),
                       static_cast<Index>(element.unknowns.size()));
  element.basis.setFromTriplets(entries.begin(), entries.end());
  return element;
}

MatrixXd FreeMatrix::reduced(const Element& element, const MatrixXd& matrix) {
  const MatrixXd half = timesSparse(matrix, element.basis);
  return timesSparse(half.transpose(), element.basis);
}

Sparse FreeMatrix::sum(const std::vector<MatrixXd>& elements) const {
  FAIRING_ASSERT(elements.size() == elements_.size());
  std::vector<MatrixXd> all(elements.size());
  inParallel(all.size(), [&](std::size_t k) { all[k] = reduced(elements_[k], elements[k]); });
  Sparse result = pattern_;
  for (std::size_t k = 0; k < all.size(); ++k) addTo(result, elements_[k].unknowns, all[k]);
  return result;
}

}  // namespace fairing::solver
