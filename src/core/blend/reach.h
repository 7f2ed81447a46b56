// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>

#include "core/layout/patch_layout.h"
#include "core/span/span_hole.h"

namespace fairing {

/// How far a strip reaches before it turns away from either side, as a factor of what its energy
/// likes best: the length of the cross tangents. Side 0 is the first chain's.
using Reach = std::array<double, 2>;

/// The rows of points next to both sides, at `reach` times their distance from the outer rows in
/// `patches`. R_v . n = 0 is homogeneous in these differences, so that tangency stays exact.
[[nodiscard]] HeldPoints heldRows(const layout::PatchLayout& layout,
                                  const Patches& patches,
                                  const Reach& reach);

}  // namespace fairing
