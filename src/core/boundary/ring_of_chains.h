// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/base/result.h"
#include "core/boundary/side_chain.h"

namespace fairing::boundary {

/// Three or more open chains round a hole with gaps, as one loop: in the order and the directions
/// for which the ways from the end of each to the start of the next one are shortest in all. The
/// first one keeps its direction. Chains that touch make one with a corner between them; that which
/// holds the first one comes first. Fails with
/// ChainsUnlike (one is closed), TooManySides (more than eight), RingWithoutGap and the codes of
/// makeOpenChains().
[[nodiscard]] Result<BoundaryLoop> ringOfChains(const std::vector<SideChain>& chains);

}  // namespace fairing::boundary
