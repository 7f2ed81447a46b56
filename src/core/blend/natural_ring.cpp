// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/natural_ring.h"

#include <utility>

#include "core/layout/junction.h"
#include "core/layout/layouts.h"
#include "core/layout/vertex_blend.h"
#include "core/span/refine.h"

namespace fairing {
Result<NaturalRing> NaturalRing::make(const boundary::ChainRing& ring,
                                      const BlendOptions& options,
                                      Progress* progress) {
  FillOptions fill = options.fill;
  if (!ring.sides.isOpen()) fill.maxPoles *= 2;  // two stars, each as large as a hole
  const auto planOf = [&](const boundary::BoundaryLoop& target) {
    if (target.isOpen()) return layout::vertexBlendPlan(target);
    return layout::junctionPlan({target, ring.cuts});
  };
  auto made = makeSpan(ring.sides, fill, planOf);
  if (!made) return fail(made.error());
  const auto span = std::make_shared<const Span>(std::move(*made));
  auto result = spanPlan(*span, fill, progress);
  if (!result) return fail(result.error());
  return NaturalRing(span, std::move(fill), std::move(*result));
}

HeldPoints NaturalRing::drawnRows(const layout::PatchLayout& layout,
                                  const Patches& patches,
                                  const Reach& reach) const {
  const solver::Points points = pointsOf(layout, patches);
  const std::size_t firstChain = span_->loop.chains().front().second;
  HeldPoints drawn;
  drawn.firmly = false;
  std::vector<Eigen::RowVector3d> values;
  for (const layout::LayoutPatch& patch : layout.patches)
    for (std::size_t k = 0; k < 4; ++k) {
      if (!patch.edges[k]) continue;
      const auto& stretches = span_->plan.cut.stretches[std::size_t(patch.edges[k]->side)];
      const double factor = reach.start[stretches.front().edge < firstChain ? 0 : 1];
      const auto outer = layout::edgePoints(patch, layout::kPatchEdges[k], 0);
      const auto inner = layout::edgePoints(patch, layout::kPatchEdges[k], 1);
      for (std::size_t i = 0; i < inner.size(); ++i) {
        drawn.points.push_back(inner[i]);
        values.emplace_back(points.row(outer[i]) +
                            factor * (points.row(inner[i]) - points.row(outer[i])));
      }
    }
  drawn.values.resize(static_cast<Eigen::Index>(values.size()), 3);
  for (std::size_t k = 0; k < values.size(); ++k)
    drawn.values.row(static_cast<Eigen::Index>(k)) = values[k];
  return drawn;
}

Result<FillResult> NaturalRing::reaching(const Reach& reach) const {
  if (reach.varies(0) || reach.varies(1))
    return fail({.code = ErrorCode::ReachVariesRound, .edge = span_->loop.sides.front().edge});
  if (reach.isNatural()) return result_;
  Patches natural = result_.patches, unguided = result_.unguided;
  for (int round = 0;; ++round) {
    const layout::PatchLayout layout = layoutOf(span_->plan, natural);
    auto result = spanAgain(*span_, unguided, drawnRows(layout, natural, reach), options_);
    if (!result || result->report.withinTolerance || round == options_.maxRefinements)
      return result;
    const auto wishes = wishedKnots(span_->plan, layout, result->report, kRefineAim);
    const auto finer = layout::refineLayout(span_->plan, layout, wishes);
    if (nothingWished(wishes) || finer.pointCount > options_.maxPoles) return result;
    natural = makePatches(finer, pointsOn(finer, natural));
    unguided = makePatches(finer, pointsOn(finer, unguided));
  }
}

}  // namespace fairing
