// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/fill_hole.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/analysis/curvature.h"
#include "core/assembly/assemble_energy.h"
#include "core/assembly/assemble_guidance.h"
#include "core/constraint/constraint_set.h"
#include "core/fill/refine.h"
#include "core/layout/layouts.h"
#include "core/solver/solve.h"

namespace fairing {
namespace {

using Patches = std::vector<spline::BsplineSurface>;

// Edges that are not polynomial are fitted this much closer than the gap allowed.
constexpr double kFitShare = 0.1;
// Refinement goes on until the deviations are below this share of the limits: they are sampled, the
// peaks are between.
constexpr double kAim = 0.8;
constexpr double kBackwards = 1e6;
constexpr double kTieShare = 1e-3;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

tl::unexpected<Error> pass(const Error& error) {
  return tl::unexpected<Error>(error);
}

Patches makePatches(const layout::PatchLayout& layout, const solver::Points& points) {
  Patches patches;
  for (const layout::LayoutPatch& from : layout.patches) {
    spline::BsplineSurface patch{
        from.u, from.v, spline::Poles(static_cast<Eigen::Index>(from.points.size()), 3)};
    for (std::size_t k = 0; k < from.points.size(); ++k)
      patch.poles.row(static_cast<Eigen::Index>(k)) = points.row(from.points[k]);
    patches.push_back(std::move(patch));
  }
  return patches;
}

// How far over the limits a report is; 1 = just within. The sum over the sides tells reports apart
// whose worst place is the same, as where an edge lies off its face. A patch that leaves a side
// backwards is worse than any.
double excess(const analysis::FillReport& report) {
  double worst = 0.0, sum = 0.0;
  for (const analysis::SideReport& side : report.sides) {
    double own = side.gap.max / report.gapLimit;
    if (side.asked != Continuity::G0) {
      own = std::max({own,
                      side.angle.max / report.angleLimit,
                      side.cornerAngle.max / report.cornerAngleLimit});
      if (side.backwards) own += kBackwards;
    }
    worst = std::max(worst, own);
    sum += own;
  }
  return worst + kTieShare * sum;
}

// One pass through the pipeline on a given layout: constraints and energy -> solver -> patches +
// report.
Result<FillResult> fillOn(const boundary::BoundaryLoop& loop,
                          const layout::PatchLayout& layout,
                          const analysis::LoopProbe& probe,
                          const FillOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  auto constraints = constraint::constrainSides(loop, layout);
  if (!constraints) return pass(constraints.error());
  solver::QuadraticProgram program;
  program.stiffness = assembly::assembleEnergy(layout, energy::energyTerms(options.energy));
  program.fixed = std::move(constraints->fixed);
  program.values = std::move(constraints->values);
  program.blocks = std::move(constraints->blocks);
  auto solution = solver::solve(program);
  if (solution && options.guidance.acts()) {
    const auto guided =
        assembly::assembleGuidance(layout, options.guidance, makePatches(layout, solution->points));
    program.coupled = guided.coupled;
    program.load = guided.load;
    solution = solver::solve(program);
  }
  if (!solution) return pass(solution.error());

  FillResult result;
  result.patches = makePatches(layout, solution->points);
  result.layout = layout.kind;
  result.summary.solveTime = secondsSince(start);
  result.report =
      analysis::measureFill(loop, probe, result.patches, sideTraces(layout), options.tolerance);
  result.reversed.assign(result.patches.size(), result.report.reversed);
  result.summary.measureTime = secondsSince(start) - result.summary.solveTime;
  result.summary.poles = layout.pointCount;
  result.summary.unknowns = solution->unknowns;
  result.summary.constraints = solution->constraints;
  result.summary.constraintResidual = solution->residual;
  result.summary.energy =
      0.5 * (solution->points.transpose() * (program.stiffness * solution->points)).trace();
  return result;
}

}  // namespace

Result<FillResult> fillHole(const boundary::BoundaryLoop& loop,
                            const FillOptions& options,
                            Progress* progress) {
  const auto start = std::chrono::steady_clock::now();
  if (const auto wrong = validate(options)) return fail(*wrong);
  const double fitTolerance = kFitShare * options.tolerance.gapFor(loop.diagonal);
  auto layout =
      layout::makeLayout(loop, {options.layout, options.degree, fitTolerance, options.maxPoles});
  if (!layout) return pass(layout.error());
  const double layoutTime = secondsSince(start);

  const analysis::LoopProbe probe = analysis::probeLoop(loop);
  std::optional<FillResult> best;
  int solves = 0;
  for (int round = 0; round <= options.maxRefinements; ++round) {
    if (progress && progress->isAbortRequested()) return fail({ErrorCode::Cancelled});
    auto tried = fillOn(loop, *layout, probe, options);
    if (!tried) return tried;
    ++solves;
    const auto wishes = wishedKnots(*layout, tried->report, kAim);
    if (!best || excess(tried->report) < excess(best->report)) best = std::move(*tried);
    if (excess(best->report) <= kAim) break;
    if (progress) progress->setFraction((round + 1.0) / (options.maxRefinements + 1.0));
    if (std::all_of(wishes.begin(), wishes.end(), [](const auto& w) { return w.empty(); })) break;
    auto finer = layout::refineLayout(loop, *layout, wishes);
    if (!finer) return pass(finer.error());
    if (finer->pointCount > options.maxPoles) break;
    *layout = std::move(*finer);
  }
  best->report.fairness = analysis::measureFairness(best->patches);
  best->summary.solves = solves;
  best->summary.layoutTime = layoutTime;
  best->summary.totalTime = secondsSince(start);
  return std::move(*best);
}

}  // namespace fairing
