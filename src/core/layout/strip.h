// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/boundary/side_chain.h"
#include "core/layout/layout_plan.h"

namespace fairing::layout {

/// One patch between two chains: the first along South, the second along North. East and West are
/// free where the chains are open, one and the same where they are closed. Side 0 of the cut is the
/// first chain, side 1 the second. Fails with the codes of cutPair().
[[nodiscard]] Result<LayoutPlan> stripPlan(const boundary::ChainPair& pair);

}  // namespace fairing::layout
