// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/layout/patch_layout.h"
#include "core/solver/quadratic_program.h"

namespace fairing::constraint {

/// Patches meet with one tangent plane along every seam that is no crease:
///   first(t) D1(t) + second(t) D2(t) = along(t) R_t(t)          (Seam::frame)
/// met with its derivative at both ends, at Greville abscissae between. First a block per inner
/// vertex, for all seams that end there; then one per seam end on the loop; then one per seam.
[[nodiscard]] std::vector<solver::TieBlock> tieSeams(const layout::PatchLayout& layout);

/// A patch closes upon itself along u: its ends, and all derivatives there that are continuous at
/// other knots (up to the fourth), are one.
/// Its South and North edges are left to the sides.
[[nodiscard]] std::vector<solver::TieBlock> tieClosing(const layout::LayoutPatch& patch);

}  // namespace fairing::constraint
