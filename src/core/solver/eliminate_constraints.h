// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/solver/quadratic_program.h"

namespace fairing::solver {

/// The solutions of all constraints as an affine space:  X = offset + basis y,  y the coordinates
/// left free.
struct AffineSpace {
  Sparse basis;             ///< 3n x m
  Eigen::VectorXd offset;   ///< 3n
  std::vector<char> bound;  ///< n flags: the point takes part in a row (or is fixed)
  int rows = 0;             ///< rows taken
  double residual = 0.0;    ///< largest left by rows that contradict others, in the rows' units
};

/// Null space and a particular solution, block by block, each by QR with column pivoting on the
/// coordinates it solves for. Dependent rows are dropped; what they contradict others by is
/// `residual`.
[[nodiscard]] AffineSpace eliminateConstraints(const QuadraticProgram& program);

}  // namespace fairing::solver
