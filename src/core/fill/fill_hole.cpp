// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/fill_hole.h"

#include <algorithm>

#include "core/analysis/curvature.h"
#include "core/analysis/measure_fill.h"
#include "core/assembly/assemble_energy.h"
#include "core/assembly/assemble_guidance.h"
#include "core/base/stopwatch.h"
#include "core/boundary/follow_support.h"
#include "core/constraint/constraint_set.h"
#include "core/fill/fill_trimmed.h"
#include "core/fill/refine.h"
#include "core/layout/layouts.h"
#include "core/solver/solve.h"

// The pipeline (docs/ARCHITECTURE.md):
//
//   BoundaryLoop -> PatchLayout -> constraints, energy -> solver -> patches -> report --> done
//                        ^                                                       |
//                        +------------------ finer knots where it is over --------+

namespace fairing {
namespace {

using Patches = std::vector<spline::BsplineSurface>;

// Edges that are not polynomial are fitted this much closer than the gap allowed.
constexpr double kFitShare = 0.1;
// Refinement goes on until the deviations are below this share of the limits: they are sampled, the
// peaks lie between.
constexpr double kAim = 0.8;
// What an edge that lies off its face may keep of its own angle: the rest of the limit is the
// solver's.
constexpr double kFollowAim = 0.65;

// A hole to fill: the loop as it is, which the result is measured against, and the one patches are
// made for.
struct Hole {
  const boundary::BoundaryLoop& loop;
  boundary::BoundaryLoop target;
  analysis::LoopProbe probe;
};

Hole prepare(const boundary::BoundaryLoop& loop, const Tolerance& tolerance) {
  boundary::BoundaryLoop target =
      boundary::followSupports(loop,
                               kFollowAim * tolerance.angle,
                               kFollowAim * std::max(tolerance.angle, tolerance.cornerAngle));
  analysis::LoopProbe probe = analysis::probeLoop(loop, target);
  return {loop, std::move(target), std::move(probe)};
}

Patches makePatches(const layout::PatchLayout& layout, const solver::Points& points) {
  Patches patches;
  for (const layout::LayoutPatch& from : layout.patches) {
    spline::Poles poles(static_cast<Eigen::Index>(from.points.size()), 3);
    for (std::size_t k = 0; k < from.points.size(); ++k)
      poles.row(static_cast<Eigen::Index>(k)) = points.row(from.points[k]);
    patches.push_back({from.u, from.v, std::move(poles)});
  }
  return patches;
}

Result<solver::QuadraticProgram> makeProgram(const Hole& hole,
                                             const layout::PatchLayout& layout,
                                             EnergyKind energy) {
  auto constraints = constraint::constrainSides(hole.target, layout);
  if (!constraints) return fail(constraints.error());
  solver::QuadraticProgram program;
  program.stiffness = assembly::assembleEnergy(layout, energy::energyTerms(energy));
  program.fixed = std::move(constraints->fixed);
  program.values = std::move(constraints->values);
  program.blocks = std::move(constraints->blocks);
  return program;
}

// Guidance is looked up near the shape it acts on: first the fill without it, then with it.
Result<solver::Solution> solveGuided(solver::QuadraticProgram& program,
                                     const layout::PatchLayout& layout,
                                     const energy::Guidance& guidance) {
  auto solution = solver::solve(program);
  if (!solution || !guidance.acts()) return solution;
  const auto guided =
      assembly::assembleGuidance(layout, guidance, makePatches(layout, solution->points));
  program.coupled = guided.coupled;
  program.load = guided.load;
  return solver::solve(program);
}

FillResult measured(const Hole& hole,
                    const layout::PatchLayout& layout,
                    const solver::Solution& solution,
                    const Tolerance& tolerance) {
  FillResult result;
  result.layout = layout.kind;
  result.patches = makePatches(layout, solution.points);
  result.report =
      analysis::measureFill(hole.loop, hole.probe, result.patches, sideTraces(layout), tolerance);
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
                          const FillOptions& options) {
  Stopwatch watch;
  auto program = makeProgram(hole, layout, options.energy);
  if (!program) return fail(program.error());
  const auto solution = solveGuided(*program, layout, options.guidance);
  if (!solution) return fail(solution.error());
  const double solveTime = watch.lap();
  FillResult result = measured(hole, layout, *solution, options.tolerance);
  result.summary.solveTime = solveTime;
  result.summary.measureTime = watch.lap();
  result.summary.energy = solver::energy(*program, solution->points);
  return result;
}

}  // namespace

Result<FillResult> fillHole(const boundary::BoundaryLoop& loop,
                            const FillOptions& options,
                            Progress* progress) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  if (options.layout == LayoutKind::Trimmed) return fillTrimmed(loop, options, progress);
  Stopwatch watch;
  const Hole hole = prepare(loop, options.tolerance);
  const double fitTolerance = kFitShare * options.tolerance.gapFor(loop.diagonal);
  auto layout = layout::makeLayout(
      hole.target, {options.layout, options.degree, fitTolerance, options.maxPoles});
  const double layoutTime = watch.lap();

  std::optional<FillResult> best;
  for (int round = 0; round <= options.maxRefinements; ++round) {
    if (progress && progress->isAbortRequested()) return fail({ErrorCode::Cancelled});
    if (!layout) return fail(layout.error());
    if (best && layout->pointCount > options.maxPoles) break;
    auto tried = fillOn(hole, *layout, options);
    if (!tried) return tried;
    tried->summary.solves = round + 1;
    const auto wishes = wishedKnots(*layout, tried->report, kAim);
    best = best ? better(std::move(*best), std::move(*tried)) : std::move(*tried);
    if (progress) progress->setFraction((round + 1.0) / (options.maxRefinements + 1.0));
    if (nothingWished(wishes)) break;
    layout = layout::refineLayout(hole.target, *layout, wishes);
  }
  best->report.fairness = analysis::measureFairness(best->patches);
  best->summary.layoutTime = layoutTime;
  best->summary.totalTime = watch.total();
  return std::move(*best);
}

}  // namespace fairing
