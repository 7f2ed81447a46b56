// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/blend_ring.h"

#include "core/layout/junction.h"
#include "core/layout/vertex_blend.h"
#include "core/span/span_plan.h"

namespace fairing {

Result<FillResult> blendRing(const boundary::ChainRing& ring,
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
  if (!ring.sides.isOpen()) fill.maxPoles *= 2;  // two stars, each as large as a hole
  const auto planOf = [&](const boundary::BoundaryLoop& target) {
    if (target.isOpen()) return layout::vertexBlendPlan(target);
    return layout::junctionPlan({target, ring.cuts});
  };
  const auto span = makeSpan(ring.sides, fill.tolerance, planOf);
  if (!span) return fail(span.error());
  return spanPlan(*span, fill, progress);
}

}  // namespace fairing
