// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/base/result.h"
#include "core/solver/pattern_factor.h"
#include "core/solver/quadratic_program.h"
#include "core/solver/solve.h"

namespace fairing::solver {

/// Programs that differ in what they are guided by and how much that weighs: `program` plus
///   1/2 X' (lambda normals + gamma points (x) I3) X - gamma load . X
/// Constraints are eliminated once; the order of elimination and the pattern of the factor are
/// kept as long as the guide couples the same coordinates, so that other weights cost one numeric
/// factorisation.
class GuidedProgram {
 public:
  explicit GuidedProgram(const QuadraticProgram& program);

  /// Another guide: 3n x 3n, n x n and 3n numbers, n the points of the program.
  void setGuide(const Sparse& normals, const Sparse& points, const Eigen::VectorXd& load);
  /// The minimiser under the guide. Fails with SystemSingular and NotFinite.
  [[nodiscard]] Result<Solution> solve(double lambda, double gamma);

 private:
  struct Part {  // of the matrix and the right side, in the free coordinates
    Sparse matrix;
    Eigen::VectorXd right;
  };
  [[nodiscard]] Part inFreedom(const Sparse& matrix, const Eigen::VectorXd* load) const;
  void analyse();

  Sparse basis_, across_;  // X = offset + basis y, and its transpose
  Eigen::VectorXd offset_;
  int ties_ = 0, rows_ = 0;
  double residual_ = 0.0;
  Part own_, normals_, points_;
  std::optional<PatternFactor> factor_;
  Sparse pattern_;
};

}  // namespace fairing::solver
