// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/blend_chains.h"

#include "core/layout/strip.h"
#include "core/span/span_plan.h"

// The pipeline (docs/ARCHITECTURE.md):
//
//   two chains -> ChainPair -> LayoutPlan (strip) -> spanPlan -> reach as the energy likes it? ->
//   done
//                                                                       | ^
//                                                                  held rows -> spanAgain
//                                                                  ---------+

namespace fairing {

std::optional<Error> validate(const BlendOptions& options) {
  for (const double reach : options.reach)
    if (!(reach > 0.0)) return Error{.code = ErrorCode::ReachNotPositive, .value = reach};
  return validate(options.fill);
}

Result<FillResult> blendChains(const boundary::ChainPair& pair,
                               const BlendOptions& options,
                               Progress* progress) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  boundary::ChainPair target = pair;
  target.sides = followedLoop(pair.sides, options.fill.tolerance);
  auto plan = layout::stripPlan(target);
  if (!plan) return fail(plan.error());
  analysis::LoopProbe probe = analysis::probeLoop(pair.sides, target.sides);
  const Span span{pair.sides, std::move(target.sides), std::move(probe), std::move(*plan)};
  auto natural = spanPlan(span, options.fill, progress);
  if (!natural || options.reach == Reach{1.0, 1.0}) return natural;
  const auto layout = layoutOf(span.plan, natural->patches);
  return spanAgain(
      span, natural->patches, heldRows(layout, natural->patches, options.reach), options.fill);
}

}  // namespace fairing
