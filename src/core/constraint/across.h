// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>

#include "core/layout/patch_layout.h"

namespace fairing::constraint {

/// The first two derivatives across a patch edge, into the patch, as weights of its first three
/// rows of control points; with respect to the patch's parameter.
struct Across {
  std::array<double, 3> first{}, second{};
};

[[nodiscard]] Across acrossOf(const layout::LayoutPatch& patch, layout::PatchEdge edge);

}  // namespace fairing::constraint
