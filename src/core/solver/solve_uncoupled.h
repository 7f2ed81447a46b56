// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/solver/eliminate_constraints.h"
#include "core/solver/solve.h"

namespace fairing::solver {

/// The minimiser of a program in which nothing couples the coordinates (`coupled` is empty), by
/// static condensation: the points no constraint touches are eliminated with one factorisation for
/// x, y and z. Fails with SystemSingular.
[[nodiscard]] Result<Points> solveUncoupled(const QuadraticProgram& program,
                                            const AffineSpace& space);

}  // namespace fairing::solver
