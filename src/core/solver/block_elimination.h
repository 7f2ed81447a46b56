// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

namespace fairing::solver {

/// One unknown of `width` columns: free, or constant + sum of factors times free unknowns.
template <int width>
struct Expression {
  bool free = true;
  Eigen::Matrix<double, 1, width> constant = Eigen::Matrix<double, 1, width>::Zero();
  std::vector<std::pair<int, double>> terms;
};

/// sum of weight * unknown = right.
template <int width>
struct EliminationRow {
  std::vector<std::pair<int, double>> entries;
  Eigen::Matrix<double, 1, width> right = Eigen::Matrix<double, 1, width>::Zero();
};

/// Solves linear rows block by block for some of their unknowns, by QR with column pivoting, and
/// hands the other unknowns through. Later blocks see what earlier ones have found. Dependent rows
/// are dropped; what they contradict others by is the residual.
template <int width>
class BlockElimination {
 public:
  using Value = Eigen::Matrix<double, 1, width>;

  /// Rows smaller than `rankThreshold` beside the largest are taken for dependent.
  BlockElimination(std::size_t unknowns, double rankThreshold)
      : all_(unknowns), rankThreshold_(rankThreshold) {}

  void fix(int unknown, const Value& value);
  [[nodiscard]] bool isFree(int unknown) const { return at(unknown).free; }
  void solve(const std::vector<EliminationRow<width>>& rows, const std::vector<int>& solvedFor);
  /// Every unknown in those that all blocks left free.
  [[nodiscard]] const std::vector<Expression<width>>& finish();

  [[nodiscard]] int rank() const { return rank_; }             ///< rows taken
  [[nodiscard]] double residual() const { return residual_; }  ///< in the rows' units

 private:
  struct System;
  [[nodiscard]] System inFreeUnknowns(const std::vector<EliminationRow<width>>& rows,
                                      const std::vector<int>& solvedFor) const;
  [[nodiscard]] const Expression<width>& at(int unknown) const {
    return all_[static_cast<std::size_t>(unknown)];
  }

  std::vector<Expression<width>> all_;
  std::vector<int> pivots_;  // in the order they were solved
  double rankThreshold_;
  int rank_ = 0;
  double residual_ = 0.0;
};

extern template class BlockElimination<1>;
extern template class BlockElimination<3>;

}  // namespace fairing::solver
