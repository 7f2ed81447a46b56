// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/solver/quadratic_program.h"

namespace fairing::solver {

/// Cholesky factors of a symmetric positive definite matrix whose inner unknowns fall into blocks
/// that do not couple: the inside of patches. Each block is eliminated with dense matrices, side by
/// side on several threads, then the border in one: for few unknowns that couple strongly this is
/// several times as fast as a sparse factorisation, which works number by number.
class ArrowFactor {
 public:
  /// `inner`: flags of the unknowns that blocks are made of; the others are the border.
  ArrowFactor(const Sparse& pattern, const std::vector<char>& inner);

  /// Multiplications that a factorisation takes.
  [[nodiscard]] double cost() const;
  /// A matrix that has no entries but those of the pattern; false where it is not positive
  /// definite.
  [[nodiscard]] bool factorize(const Sparse& matrix);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Block {
    std::vector<int> own;     // unknowns
    std::vector<int> border;  // places in border_ of those it couples with
    Eigen::MatrixXd lower;    // L
    Eigen::MatrixXd across;   // L^-1 times its coupling with the border
    Eigen::MatrixXd update;   // what it takes off the border's matrix, the lower triangle
    bool isDefinite = false;
  };
  void eliminate(const Sparse& matrix, Block& block) const;

  std::vector<Block> blocks_;
  std::vector<int> border_;   // unknowns
  std::vector<int> place_;    // of every unknown in its block's own, or in border_
  std::vector<int> blockOf_;  // of every unknown; -1 = the border
  Eigen::MatrixXd lower_;     // of what is left on the border
};

}  // namespace fairing::solver
