// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/blend_chains.h"

#include "core/layout/strip.h"
#include "core/span/span_plan.h"

// The pipeline (docs/ARCHITECTURE.md):
//
//   two chains -> ChainPair -> LayoutPlan (strip) -> spanPlan -> done

namespace fairing {

Result<FillResult> blendChains(const boundary::ChainPair& pair,
                               const BlendOptions& options,
                               Progress* progress) {
  if (const auto wrong = validate(options.fill)) return fail(*wrong);
  boundary::ChainPair target = pair;
  target.sides = followedLoop(pair.sides, options.fill.tolerance);
  auto plan = layout::stripPlan(target);
  if (!plan) return fail(plan.error());
  analysis::LoopProbe probe = analysis::probeLoop(pair.sides, target.sides);
  return spanPlan({pair.sides, std::move(target.sides), std::move(probe), std::move(*plan)},
                  options.fill,
                  progress);
}

}  // namespace fairing
