// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <memory>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/blend/blend_options.h"
#include "core/blend/natural_blend.h"
#include "core/boundary/side_chain.h"
#include "core/span/fill_result.h"

namespace fairing {

/// A blend, and what it was made from.
struct Blend {
  FillResult fill;
  std::shared_ptr<const NaturalBlend> natural;  ///< for other reaches at the cost of one solve
};

/// Joins two chains of sides by one strip that leaves each of them as its sides ask and minimises
/// the chosen energy; ends of open chains that follow nothing are free, closed chains give a strip
/// that closes upon itself with its curvature. Refined, measured and returned as fillHole() does.
/// Fails with the codes of validate() and checkDepartures(), SystemSingular, NotFinite or
/// Cancelled. docs/algorithms/strip_blend.md
[[nodiscard]] Result<Blend> blendChains(const boundary::ChainPair& pair,
                                        const BlendOptions& options,
                                        Progress* progress = nullptr);

}  // namespace fairing
