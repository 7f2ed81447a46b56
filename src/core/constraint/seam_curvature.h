// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/layout/patch_layout.h"
#include "core/solver/quadratic_program.h"

namespace fairing::constraint {

/// Patches meet with one curvature along every seam that is to be curved (Seam::continuity G2),
/// linearised about points that already obey the seams' ties. These give one tangent plane and one
/// second fundamental form but for its entry across the seam; that one agrees where
///   n . (R2_ww - b^2 R1_vv - 2 a b R1_vt - a^2 R_tt) = 0,   D2 = b D1 + a R_t   (Seam::frame).
/// At inner vertices, and at Greville abscissae between them; at a seam's end on the loop the sides
/// see to it. One block for all seams. Newton's method: repeated about its own solution the rows
/// become exact.
[[nodiscard]] std::optional<solver::ConstraintBlock> seamCurvatureRows(
    const layout::PatchLayout& layout, const solver::Points& about);

}  // namespace fairing::constraint
