// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/solver/quadratic_program.h"

namespace fairing::solver {

/// Matrices T'HT in the directions T that constraints leave free, H the sum of dense matrices of
/// elements, each of a few points. Which entries there are depends on the points alone and is found
/// once.
class FreeMatrix {
 public:
  /// `freedom`: T, 3n x m; `elements`: the points of each.
  FreeMatrix(const Sparse& freedom, const std::vector<std::vector<int>>& elements);

  /// All entries that any sum may have, nought.
  [[nodiscard]] const Sparse& pattern() const { return pattern_; }
  /// One symmetric matrix an element, 3 coordinates a point. The same with any number of threads.
  [[nodiscard]] Sparse sum(const std::vector<Eigen::MatrixXd>& elements) const;

 private:
  using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  struct Element {
    std::vector<int> unknowns;  // ascending
    Sparse basis;               // rows of T of its coordinates, columns of its unknowns
  };
  [[nodiscard]] static Element elementOf(const RowMajor& rows, const std::vector<int>& points);
  [[nodiscard]] static Eigen::MatrixXd reduced(const Element& element,
                                               const Eigen::MatrixXd& matrix);

  std::vector<Element> elements_;
  Sparse pattern_;
};

}  // namespace fairing::solver
