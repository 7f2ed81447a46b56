// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/solver/quadratic_program.h"

namespace fairing::solver {

/// The points of a program written in those its ties leave free:  x = basis z + offset.
struct TiedPoints {
  Sparse basis;           ///< n x m
  Points offset;          ///< n x 3
  std::vector<int> free;  ///< the m points left free, ascending
  double residual = 0.0;  ///< largest left by ties that contradict others, mm
};

/// Solves the ties, block by block, by QR with column pivoting; fixed points are constants.
/// Dependent rows are dropped.
[[nodiscard]] TiedPoints tiePoints(const QuadraticProgram& program);

/// The same program in the free points alone: no ties are left, nothing else changes. What couples
/// the coordinates is left out.
[[nodiscard]] QuadraticProgram withoutTies(const QuadraticProgram& program, const TiedPoints& tied);

}  // namespace fairing::solver
