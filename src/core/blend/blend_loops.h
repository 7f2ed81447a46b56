// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/blend/blend_options.h"
#include "core/boundary/boundary_loop.h"
#include "core/span/fill_result.h"

namespace fairing {

/// Joins three or more closed chains (boundary::ringOfLoops()) by patches that leave each of them
/// as its sides ask, meet each other G1 and minimise the chosen energy; front and back may have as
/// many control points as a hole each. Refined, measured and returned as fillHole() does. Fails
/// with JunctionReach where a reach is not 1, JunctionWish, the codes of validate(),
/// SystemSingular, NotFinite or Cancelled. docs/algorithms/junction.md
[[nodiscard]] Result<FillResult> blendLoops(const boundary::BoundaryLoop& loop,
                                            const BlendOptions& options,
                                            Progress* progress = nullptr);

}  // namespace fairing
