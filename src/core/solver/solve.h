// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/solver/quadratic_program.h"

namespace fairing::solver {

struct Solution {
  Points points;          ///< n x 3
  int unknowns = 0;       ///< coordinates left free by the constraints
  int constraints = 0;    ///< independent rows
  double residual = 0.0;  ///< of rows that contradict others, in the rows' units
};

/// The minimiser of a quadratic program. Constraints are eliminated exactly, never penalised. Fails
/// with SystemSingular or NotFinite.
[[nodiscard]] Result<Solution> solve(const QuadraticProgram& program);

/// Directions in which a solution may move without leaving the constraints: 3n x m.
[[nodiscard]] Sparse freedomOf(const QuadraticProgram& program);

/// 1/2 sum stiffness_ij x_i . x_j at given points: the energy without what couples or loads them.
[[nodiscard]] double energy(const Sparse& stiffness, const Points& points);

}  // namespace fairing::solver
