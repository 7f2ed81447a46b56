// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/energy/energy.h"
#include "core/layout/patch_layout.h"
#include "core/solver/quadratic_program.h"

namespace fairing::assembly {

/// The matrix H of a quadratic energy over all patches: energy = 1/2 sum_ij H_ij x_i . x_j, points
/// numbered as in the layout. Tensor products of exact one-dimensional integrals; n x n, symmetric
/// positive semidefinite.
[[nodiscard]] solver::Sparse assembleEnergy(const layout::PatchLayout& layout,
                                            const energy::EnergyTerms& terms);

}  // namespace fairing::assembly
