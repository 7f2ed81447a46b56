// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/base/result.h"
#include "core/boundary/side_chain.h"

namespace fairing::boundary {

/// Whether the second chain runs along the first rather than against it: a strip between their
/// starts and their ends would be less twisted than one from start to end.
[[nodiscard]] bool runsAlong(const SideChain& first, const SideChain& second);

/// Places on either chain of a pair that belong together.
struct StripCut {
  LoopPlace first, second;
};

/// Where the strip between two chains is to be cut, along the first chain: at every corner of
/// either chain and at the pairs set, matched as the pair asks. Of open chains the first and the
/// last cut are their ends. Closed chains without a corner have one cut, where a strip of one patch
/// closes: that of the one pair set, or where the two are nearest to each other when the sum of the
/// squared distances of points that belong together, by arc length, is least; where they are
/// equally far all round, at the first chain's start.
/// Fails with CornersDiffer, PairsCross, AlignmentOutOfRange or AlignmentUnused.
[[nodiscard]] Result<std::vector<StripCut>> matchChains(const ChainPair& pair);

}  // namespace fairing::boundary
