// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/boundary/side_chain.h"
#include "core/layout/layout_plan.h"

namespace fairing::layout {

/// Patches side by side between two chains: the first along South, the second along North, cut
/// where matchChains() says, sides as in cutPair(). East and West are seams of neighbours, at
/// the ends of open chains free or the sides there; of one patch between closed chains they are one
/// and the same. Fails with the codes of matchChains() and cutPair().
[[nodiscard]] Result<LayoutPlan> stripPlan(const boundary::ChainPair& pair);

/// Whether an end of a strip follows sides.
[[nodiscard]] bool followsAtEnds(const QuadMesh& strip);

}  // namespace fairing::layout
