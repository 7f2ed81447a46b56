// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/pattern_factor.h"

#include <Eigen/SparseCholesky>

namespace fairing::solver {
namespace {

// Dense matrices are worked on so many times as fast as sparse ones.
constexpr double kDenseSpeed = 4.0;

// Coordinates of their own: no tie and no row takes part in them.
std::vector<char> innerUnknowns(const Sparse& basis) {
  std::vector<char> inner;
  for (int k = 0; k < basis.cols(); ++k) inner.push_back(basis.col(k).nonZeros() == 1);
  return inner;
}

}  // namespace

class PatternFactor::SparseFactor : public Eigen::SimplicialLDLT<Sparse> {
 public:
  /// Multiplications that a factorisation takes, once the pattern is analysed.
  [[nodiscard]] double cost() const {
    return 0.5 * m_nonZerosPerCol.template cast<double>().squaredNorm();
  }
};

PatternFactor::PatternFactor(const Sparse& pattern, const Sparse& basis)
    : sparse_(std::make_shared<SparseFactor>()) {
  sparse_->analyzePattern(pattern);
  arrow_.emplace(pattern, innerUnknowns(basis));
  if (arrow_->cost() > kDenseSpeed * sparse_->cost())
    arrow_.reset();
  else
    sparse_.reset();
}

bool PatternFactor::factorize(const Sparse& matrix) {
  if (arrow_) return arrow_->factorize(matrix);
  sparse_->factorize(matrix);
  return sparse_->info() == Eigen::Success && (sparse_->vectorD().array() > 0.0).all();
}

Eigen::VectorXd PatternFactor::solve(const Eigen::VectorXd& right) const {
  return arrow_ ? arrow_->solve(right) : Eigen::VectorXd(sparse_->solve(right));
}

}  // namespace fairing::solver
