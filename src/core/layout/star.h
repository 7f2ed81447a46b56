// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/layout/layout_plan.h"
#include "core/layout/loop_corners.h"

namespace fairing::layout {

// A patch a corner, round one inner vertex O:
//
//            A1 ------ B1 ------ A0
//             |        |         |
//             |   1    |    0    |       side 2k   from B_k to corner A_k
//            B2 ------ O ------ B0       side 2k+1 from A_k to B_k+1
//              `.      |         |
//                `.  2 |  ...    |
//                  A2 ...
//
/// Three corners or more. The spokes end at B_k: where a split place lies between two corners, or
/// in the middle of the way between them. Fails with WrongSideCount (value = number of corners) and
/// LayoutUnfit where more than one split place lies between two corners.
[[nodiscard]] Result<LayoutPlan> starPlan(const boundary::BoundaryLoop& loop,
                                          const std::vector<CornerRole>& roles);

}  // namespace fairing::layout
