// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/fill_hole.h"

#include <algorithm>

#include "core/analysis/curvature.h"
#include "core/analysis/measure_fill.h"
#include "core/analysis/measure_seams.h"
#include "core/base/stopwatch.h"
#include "core/boundary/follow_support.h"
#include "core/fill/fair_shape.h"
#include "core/fill/fill_trimmed.h"
#include "core/fill/pass_through.h"
#include "core/fill/refine.h"
#include "core/fill/span_hole.h"
#include "core/layout/layouts.h"

// The pipeline (docs/ARCHITECTURE.md):
//
//   BoundaryLoop -> LayoutPlan -> fair shape on few knots -+
//                        |                                 |
//                        +-> PatchLayout -> constraints, energy -> solver -> patches -> report ->
//                        done
//                                ^                                                        |
//                                +------------------ finer knots where it is over --------+

namespace fairing {
namespace {

// Edges that are not polynomial are fitted this much closer than the gap allowed.
constexpr double kFitShare = 0.3;
// Refinement goes on until the deviations are below this share of the limits: they are sampled, the
// peaks lie between.
constexpr double kAim = 0.6;
// Solves about the last one's solution that make the rows of G2 sides and inner constraints exact.
constexpr int kNewtonSteps = 3;
// What an edge that lies off its face may keep of its own angle: the rest of the limit is the
// solver's.
constexpr double kFollowAim = 0.65;

// A hole to fill: the loop as it is, which the result is measured against, and the way it is to be
// spanned.
struct Hole {
  const boundary::BoundaryLoop& loop;
  boundary::BoundaryLoop target;
  analysis::LoopProbe probe;
  layout::LayoutPlan plan;
};

Result<Hole> prepare(const boundary::BoundaryLoop& loop,
                     LayoutKind kind,
                     const FillOptions& options) {
  const Tolerance& tolerance = options.tolerance;
  boundary::BoundaryLoop target =
      boundary::followSupports(loop,
                               kFollowAim * tolerance.angle,
                               kFollowAim * std::max(tolerance.angle, tolerance.cornerAngle));
  auto plan = layout::planLayout(target, kind);
  if (!plan) return fail(plan.error());
  analysis::LoopProbe probe = analysis::probeLoop(loop, target);
  return Hole{loop, std::move(target), std::move(probe), std::move(*plan)};
}

FillResult measured(const Hole& hole,
                    const layout::PatchLayout& layout,
                    const solver::Solution& solution,
                    const FillOptions& options) {
  FillResult result;
  result.layout = layout.kind;
  result.patches = makePatches(layout, solution.points);
  result.report = analysis::measureFill(
      hole.loop, hole.probe, result.patches, sideTraces(hole.plan, layout), options.tolerance);
  analysis::addSeams(result.report, result.patches, seamTraces(layout));
  addInner(result.report, result.patches, options.through);
  for (std::size_t k = 0; k < hole.target.sides.size(); ++k)
    result.report.sides[k].followedBy = hole.target.sides[k].followedBy;
  result.reversed.assign(result.patches.size(), result.report.reversed);
  result.summary.poles = layout.pointCount;
  result.summary.unknowns = solution.unknowns;
  result.summary.constraints = solution.constraints;
  result.summary.constraintResidual = solution.residual;
  return result;
}

// One pass on a given layout.
Result<FillResult> fillOn(const Hole& hole,
                          const layout::PatchLayout& layout,
                          const std::optional<FairShape>& shape,
                          const FillOptions& options) {
  Stopwatch watch;
  Aim aim;
  if (shape) aim.shape = pointsOn(layout, shape->patches);
  auto program = makeProgram(hole.plan, layout, options.energy, aim);
  if (!program) return fail(program.error());
  auto solution = solveGuided(*program, layout, options.guidance);
  const int newtonSteps = isIterated(hole.plan.cut.loop, options) ? kNewtonSteps : 0;
  for (int k = 0; solution && k < newtonSteps; ++k) {
    aim.about = solution->points;
    program = makeProgram(hole.plan, layout, options.energy, aim, options.through);
    if (!program) return fail(program.error());
    solution = solveGuided(*program, layout, options.guidance);
  }
  if (!solution) return fail(solution.error());
  const double solveTime = watch.lap();
  FillResult result = measured(hole, layout, *solution, options);
  result.summary.solveTime = solveTime;
  result.summary.measureTime = watch.lap();
  result.summary.energy = solver::energy(*program, solution->points);
  return result;
}

// The whole way with one kind of layout.
Result<FillResult> fillWith(LayoutKind kind,
                            const boundary::BoundaryLoop& loop,
                            const FillOptions& options,
                            Progress* progress) {
  if (kind == LayoutKind::Trimmed) return fillTrimmed(loop, options, progress);
  Stopwatch watch;
  const auto hole = prepare(loop, kind, options);
  if (!hole) return fail(hole.error());
  const double fitTolerance = kFitShare * options.tolerance.gapFor(loop.diagonal);
  auto layout = layout::makeLayout(hole->plan, {options.degree, fitTolerance, options.maxPoles});
  const double layoutTime = watch.lap();
  const auto shape = fairShape(hole->plan, layout, options, loop.diagonal, progress);
  if (!shape) return fail(shape.error());
  if (*shape) layout = layout::withKnotsOf(hole->plan, layout, (*shape)->layout);

  std::optional<FillResult> best;
  for (int round = 0; round <= options.maxRefinements; ++round) {
    if (progress && progress->isAbortRequested()) return fail({ErrorCode::Cancelled});
    if (best && layout.pointCount > options.maxPoles) break;
    auto tried = fillOn(*hole, layout, *shape, options);
    if (!tried) return tried;
    tried->summary.solves = round + 1;
    auto wishes = wishedKnots(hole->plan, layout, tried->report, kAim);
    wishForInner(layout, tried->patches, options.through, kAim * tried->report.gapLimit, wishes);
    best = best ? better(std::move(*best), std::move(*tried)) : std::move(*tried);
    if (progress) progress->setFraction((round + 1.0) / (options.maxRefinements + 1.0));
    if (nothingWished(wishes)) break;
    layout = layout::refineLayout(hole->plan, layout, wishes);
  }
  best->report.fairness = analysis::measureFairness(best->patches);
  best->summary.layoutTime = layoutTime;
  best->summary.totalTime = watch.total();
  return std::move(*best);
}

void noteTinySides(const boundary::BoundaryLoop& loop, analysis::FillReport& report) {
  for (const boundary::BoundarySide& side : loop.sides)
    if (layout::isTiny(side, loop.diagonal))
      report.notes.push_back(
          {analysis::NoteCode::EdgeAbsorbed, side.edge, side.ribbon.curve(0.5).point, side.length});
}

}  // namespace

Result<FillResult> fillHole(const boundary::BoundaryLoop& loop,
                            const FillOptions& options,
                            Progress* progress) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  if (const auto tooMany = layout::tooManySides(loop)) return fail(*tooMany);
  if (options.layout != LayoutKind::Auto) return fillWith(options.layout, loop, options, progress);
  std::optional<Result<FillResult>> best;
  for (const LayoutKind kind : layout::suitableKinds(loop)) {
    auto tried = fillWith(kind, loop, options, progress);
    if (!tried && tried.error().code == ErrorCode::Cancelled) return tried;
    if (best && *best && tried)
      best = better(std::move(**best), std::move(*tried));
    else if (!best || (!*best && tried))
      best = std::move(tried);
    if (*best && (*best)->report.withinTolerance) break;
  }
  if (*best) noteTinySides(loop, (*best)->report);
  return std::move(*best);
}

}  // namespace fairing
