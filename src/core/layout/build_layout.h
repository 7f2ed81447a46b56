// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/layout/layout_plan.h"
#include "core/layout/patch_layout.h"

namespace fairing::layout {

/// The patches of a plan on given knots, a vector a strip over [0, 1].
[[nodiscard]] PatchLayout buildLayout(const LayoutPlan& plan,
                                      std::vector<spline::KnotVector> stripKnots);

}  // namespace fairing::layout
