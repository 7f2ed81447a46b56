// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/layout/patch_layout.h"
#include "core/solver/quadratic_program.h"

namespace fairing::constraint {

/// What the sides ask of a layout's points: some are known, the others obey linear rows.
struct ConstraintSet {
  std::vector<char> fixed;  ///< a flag per point
  solver::Points values;    ///< read where fixed
  std::vector<solver::TieBlock> ties;
  std::vector<solver::ConstraintBlock> blocks;
};

/// G0 (the outer row of poles is the side's curve) and G1 (R_v . n = 0) for every side that asks:
/// first a block per corner for its twist, then one per side. Fails with SupportNormalSingular.
/// docs/algorithms/quad_fill.md
/// Sides and seams that ask for G2 get their curvature rows only where there are points to
/// linearise them about (curvature_rows.h, seam_curvature.h).
[[nodiscard]] Result<ConstraintSet> constrainSides(const boundary::BoundaryLoop& loop,
                                                   const layout::PatchLayout& layout,
                                                   const solver::Points* about = nullptr);

}  // namespace fairing::constraint
