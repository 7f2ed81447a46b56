// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/constraint/tangent_plane.h"

namespace fairing::constraint {

/// Normal curvature across the sides that ask for G2, linearised about points that already meet the
/// sides G1 (V = R_v there, II the support's second fundamental form):
///   R_vv . n = 2 II(V, R_v) - II(V, V)
/// collocated at Greville abscissae, in one block for all patches. Where two G2 sides meet in a
/// corner both ask for the same control point; they get the mean. Where a seam ends on a side, the
/// seam itself is asked once, and the row next to it in one of the patches: the seam's ties carry
/// it over to the other. Newton's method: repeated about its own solution the rows become exact.
[[nodiscard]] std::optional<solver::ConstraintBlock> curvatureRows(
    const layout::PatchLayout& layout,
    const std::vector<std::array<std::optional<ConstrainedEdge>, 4>>& patches,
    const solver::Points& about);

}  // namespace fairing::constraint
