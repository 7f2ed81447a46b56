// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/natural_strip.h"

#include <utility>

#include "core/layout/strip.h"

namespace fairing {

NaturalStrip::NaturalStrip(Span span, FillOptions options, FillResult result)
    : span_(std::move(span)), options_(std::move(options)), result_(std::move(result)) {}

Result<NaturalStrip> NaturalStrip::make(const boundary::ChainPair& pair,
                                        const FillOptions& options,
                                        Progress* progress) {
  boundary::ChainPair target = pair;
  target.sides = followedLoop(pair.sides, options.tolerance);
  auto plan = layout::stripPlan(target);
  if (!plan) return fail(plan.error());
  analysis::LoopProbe probe = analysis::probeLoop(pair.sides, target.sides);
  Span span{pair.sides, std::move(target.sides), std::move(probe), std::move(*plan)};
  auto result = spanPlan(span, options, progress);
  if (!result) return fail(result.error());
  return NaturalStrip(std::move(span), options, std::move(*result));
}

Result<FillResult> NaturalStrip::reaching(const Reach& reach) const {
  const auto layout = layoutOf(span_.plan, result_.patches);
  return spanAgain(span_, result_.patches, heldRows(layout, result_.patches, reach), options_);
}

}  // namespace fairing
