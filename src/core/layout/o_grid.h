// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/layout/layout_plan.h"
#include "core/layout/loop_corners.h"

namespace fairing::layout {

/// Whether a loop bends somewhere much more sharply than on the whole.
[[nodiscard]] bool bendsSharply(const boundary::BoundaryLoop& loop);

// Four patches round an inner one; no patch has a corner on the loop, which may be smooth all
// round:
//
//        B2 ------<------ B1
//         |`.    1      ,'|
//         |  V2 --<-- V1  |        side k from B_k to B_k+1
//         | 2 |   4   | 0 |
//         |  V3 -->-- V0  |
//         |,'    3      `.|
//        B3 ------>------ B0
//
/// For loops with at most four places that are not smooth; these are among the B_k, the others are
/// spread over the lengths between them. On a smooth loop one lies in its sharpest bend, if it has
/// one, or else they lie half way between its long and its short axis. Fails with LayoutUnfit.
[[nodiscard]] Result<LayoutPlan> oGridPlan(const boundary::BoundaryLoop& loop,
                                           const std::vector<CornerRole>& roles);

}  // namespace fairing::layout
