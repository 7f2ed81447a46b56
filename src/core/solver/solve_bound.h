// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/solver/eliminate_constraints.h"

namespace fairing::solver {

/// The minimiser over the solutions of all constraints of a program in which nothing couples the
/// coordinates (`coupled` is empty). Dense: for few points, those a Condensation leaves. Fails with
/// SystemSingular.
[[nodiscard]] Result<Points> solveBound(const QuadraticProgram& program, const AffineSpace& space);

}  // namespace fairing::solver
