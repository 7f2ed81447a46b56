// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/layout/layout_plan.h"
#include "core/layout/patch_layout.h"

namespace fairing::layout {

/// The seam of two patches with its frames. At an inner vertex they come from the picture: any
/// planar configuration of the edges that meet there is an affine image of it, so the tangent plane
/// and its map are left to the energy. At a vertex on the loop they come from the loop's own
/// tangents.
[[nodiscard]] Seam seamOf(const LayoutPlan& plan, const QuadSeam& seam);

}  // namespace fairing::layout
