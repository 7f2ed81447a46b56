// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/blend/blend_chains.h"
#include "core/blend/blend_options.h"
#include "core/boundary/chain_ring.h"

namespace fairing {

/// Joins three or more chains (boundary::ringOfLoops(), ringOfChains()) by patches that leave each
/// of them as its sides ask, meet each other G1 and minimise the chosen energy; between open chains
/// their edges are free. Front and back of a junction may have as many control points as a hole
/// each. Refined, measured and returned as fillHole() does. The reach of the second side is that of
/// all chains but the first. Fails with ReachVariesRound, JunctionWish, the codes of validate() and
/// of the plans (layout/junction.h, layout/vertex_blend.h), SystemSingular, NotFinite or Cancelled.
/// docs/algorithms/junction.md
[[nodiscard]] Result<Blend> blendRing(const boundary::ChainRing& ring,
                                      const BlendOptions& options,
                                      Progress* progress = nullptr);

}  // namespace fairing
