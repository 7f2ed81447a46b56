// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/blend_loops.h"

#include "core/layout/junction.h"
#include "core/span/span_plan.h"

namespace fairing {

Result<FillResult> blendLoops(const boundary::BoundaryLoop& loop,
                              const BlendOptions& options,
                              Progress* progress) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  for (const std::size_t side : {std::size_t(0), std::size_t(1)}) {
    for (const double reach : {options.reach.at(side, 0.0), options.reach.at(side, 1.0)})
      if (reach != 1.0) return fail({.code = ErrorCode::JunctionReach, .value = reach});
    if (options.departure[side] != boundary::Departure::Free)
      return fail({.code = ErrorCode::JunctionWish, .detail = "direction of departure"});
    if (options.leaving[side] != boundary::Leaving::Onwards)
      return fail({.code = ErrorCode::JunctionWish, .detail = "flip"});
  }
  FillOptions fill = options.fill;
  fill.maxPoles *= 2;  // front and back: two stars, each as large as a hole
  const auto span = makeSpan(loop, fill.tolerance, layout::junctionPlan);
  if (!span) return fail(span.error());
  return spanPlan(*span, fill, progress);
}

}  // namespace fairing
