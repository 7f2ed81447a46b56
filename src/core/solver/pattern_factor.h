// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "core/solver/arrow_factor.h"
#include "core/solver/quadratic_program.h"

namespace fairing::solver {

/// Cholesky factors of symmetric positive definite matrices of one pattern in the free coordinates
/// of a program. The pattern is analysed once; of a sparse factorisation and ArrowFactor, whose
/// inner unknowns are those that no tie and no row takes part in, the one is taken that costs less.
class PatternFactor {
 public:
  /// `basis`: the directions that the constraints leave free, 3n x m; `pattern`: m x m.
  PatternFactor(const Sparse& pattern, const Sparse& basis);

  /// A matrix of that pattern; false where it is not positive definite.
  [[nodiscard]] bool factorize(const Sparse& matrix);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  class SparseFactor;
  std::shared_ptr<SparseFactor> sparse_;  // of the two one
  std::optional<ArrowFactor> arrow_;
};

}  // namespace fairing::solver
