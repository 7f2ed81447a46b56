// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/layout/layout_plan.h"
#include "core/layout/loop_corners.h"

namespace fairing::layout {

/// One patch between four corners: side 0 South, 1 East, 2 North, 3 West. Every place that is not
/// smooth is a corner. Fails with WrongSideCount, value = number of corners.
[[nodiscard]] Result<LayoutPlan> quadPlan(const boundary::BoundaryLoop& loop,
                                          const std::vector<CornerRole>& roles);

}  // namespace fairing::layout
