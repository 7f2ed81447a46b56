// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/span_plan.h"

#include <algorithm>

#include "core/analysis/measure_fairness.h"
#include "core/analysis/measure_guidance.h"
#include "core/base/stopwatch.h"
#include "core/boundary/follow_support.h"
#include "core/layout/layouts.h"
#include "core/span/fair_shape.h"
#include "core/span/one_pass.h"
#include "core/span/pass_through.h"
#include "core/span/refine.h"

namespace fairing {
namespace {

// Edges that are not polynomial are fitted this much closer than the gap allowed.
constexpr double kFitShare = 0.3;
// What an edge that lies off its face may keep of its own angle: the rest of the limit is the
// solver's.
constexpr double kFollowAim = 0.65;

// Where the first patch on a closed edge starts: what is measured must not depend on the start of
// the edge.
std::vector<double> startsOf(const layout::LayoutPlan& plan, const boundary::BoundaryLoop& loop) {
  std::vector<double> starts(loop.sides.size(), 0.0);
  for (auto side = plan.cut.stretches.rbegin(); side != plan.cut.stretches.rend(); ++side)
    if (const boundary::Stretch& first = side->front(); loop.next(first.edge) == first.edge)
      starts[first.edge] = first.from;
  return starts;
}

void addHistory(const FairShape& shape, FillResult& result) {
  const solver::ShapeHistory& history = shape.history;
  result.summary.shape = history;
  if (history.end == solver::ShapeEnd::Limit)
    result.report.notes.push_back({.code = analysis::NoteCode::ShapeLimit,
                                   .value = static_cast<double>(history.steps.size())});
  if (history.end == solver::ShapeEnd::Stopped)
    result.report.notes.push_back({.code = analysis::NoteCode::ShapeStopped,
                                   .value = static_cast<double>(history.steps.size())});
  if (history.end == solver::ShapeEnd::Undefined)
    result.report.notes.push_back(
        {.code = analysis::NoteCode::ShapeUndefined, .where = history.where});
}

// Patches and what they lie on.
struct Fitted {
  FillResult result;
  layout::PatchLayout layout;
};

// Patches on a layout, and the shape's knots, that follow the sides as closely as asked: solved,
// measured and given knots where that is not enough.
Result<Fitted> fitTo(const Span& span,
                     layout::PatchLayout layout,
                     const std::optional<FairShape>& shape,
                     const FillOptions& options,
                     Progress* progress) {
  if (shape) layout = layout::withKnotsOf(span.plan, layout, shape->layout);
  std::optional<Fitted> best;
  std::optional<Patches> latest;
  for (int round = 0; round <= options.maxRefinements; ++round) {
    if (progress && progress->isAbortRequested()) return fail({ErrorCode::Cancelled});
    if (best && layout.pointCount > options.maxPoles) break;
    Aim aim;
    if (shape) aim.shape = pointsOn(layout, shape->patches);
    if (latest) aim.near = pointsOn(layout, *latest);
    auto tried = fillOn(span, layout, std::move(aim), options, progress);
    if (!tried) return fail(tried.error());
    tried->summary.solves = round + 1;
    if (options.guidance.isDrawn()) latest = tried->patches;
    auto wishes = wishedKnots(span.plan, layout, tried->report, kRefineAim);
    wishForInner(
        layout, tried->patches, options.through, kRefineAim * tried->report.gapLimit, wishes);
    if (!best || excess(tried->report) < excess(best->result.report))
      best = Fitted{std::move(*tried), layout};
    else
      best->result.summary.solves = round + 1;
    if (progress) progress->setFraction((round + 1.0) / (options.maxRefinements + 1.0));
    if (nothingWished(wishes)) break;
    layout = layout::refineLayout(span.plan, layout, wishes);
  }
  return std::move(*best);
}

// The shape and its patches on finer knots, unless these miss limits that the coarser ones kept.
// The seconds that its steps took.
Result<double> goFurther(const Span& span,
                         const layout::PatchLayout& layout,
                         const FillOptions& options,
                         Progress* progress,
                         std::optional<FairShape>& shape,
                         Fitted& best) {
  Stopwatch watch;
  std::optional<FairShape> finer = shape;
  const auto further = fairFurther(
      span.plan, best.layout, best.result.unguided, options, span.loop.diagonal, progress, *finer);
  if (!further) return fail(further.error());
  const double seconds = watch.lap();
  if (!*further) {
    shape = std::move(finer);  // may have been stopped
    return seconds;
  }
  auto fitted = fitTo(span, layout, finer, options, progress);
  if (!fitted) return fail(fitted.error());
  if (best.result.report.withinTolerance && !fitted->result.report.withinTolerance) return seconds;
  best = std::move(*fitted);
  shape = std::move(finer);
  return seconds;
}

// What is measured on the patches that are kept, and not on those on the way to them.
Result<void> measureKept(const Span& span, const FillOptions& options, FillResult& result) {
  result.report.fairness = analysis::measureFairness(result.patches, span.loop.diagonal);
  return analysis::addGuidance(result.report, options.guidance, result.patches);
}

}  // namespace

Result<Span> makeSpan(const boundary::BoundaryLoop& loop,
                      const FillOptions& options,
                      const PlanOf& planOf) {
  const Tolerance& tolerance = options.tolerance;
  auto target =
      boundary::followSupports(loop,
                               kFollowAim * tolerance.angle,
                               kFollowAim * std::max(tolerance.angle, tolerance.cornerAngle));
  auto plan = planOf(target);
  if (!plan) return fail(plan.error());
  plan->inner = options.inner;
  analysis::LoopProbe probe = analysis::probeLoop(loop, target, startsOf(*plan, loop));
  return Span{loop, std::move(target), std::move(probe), std::move(*plan)};
}

Result<FillResult> spanPlan(const Span& span, const FillOptions& options, Progress* progress) {
  Stopwatch watch;
  if (progress) progress->setFraction(0.0);  // it may have counted another plan
  const double diagonal = span.loop.diagonal;
  const double fitTolerance = kFitShare * options.tolerance.gapFor(diagonal);
  const auto layout =
      layout::makeLayout(span.plan, {options.degree, fitTolerance, options.maxPoles});
  const double layoutTime = watch.lap();
  auto shape = fairShape(span.plan, layout, options, diagonal, progress);
  if (!shape) return fail(shape.error());
  double shapeTime = watch.lap();
  auto best = fitTo(span, layout, *shape, options, progress);
  if (!best) return fail(best.error());
  if (*shape) {
    const auto went = goFurther(span, layout, options, progress, *shape, *best);
    if (!went) return fail(went.error());
    shapeTime += *went;
    addHistory(**shape, best->result);
  }
  FillResult& result = best->result;
  if (const auto measured = measureKept(span, options, result); !measured)
    return fail(measured.error());
  result.summary.layoutTime = layoutTime;
  result.summary.shapeTime = shapeTime;
  result.summary.totalTime = watch.total();
  return std::move(result);
}

Result<FillResult> spanAgain(const Span& span,
                             const Patches& before,
                             const HeldPoints& held,
                             const FillOptions& options) {
  Stopwatch watch;
  const layout::PatchLayout layout = layoutOf(span.plan, before);
  Aim aim;
  aim.shape = pointsOf(layout, before);
  aim.held = held;
  auto result = fillOn(span, layout, std::move(aim), options);
  if (!result) return result;
  result->summary.solves = 1;
  if (const auto measured = measureKept(span, options, *result); !measured)
    return fail(measured.error());
  result->summary.totalTime = watch.total();
  return result;
}

}  // namespace fairing
