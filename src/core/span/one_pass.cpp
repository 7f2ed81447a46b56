// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/one_pass.h"

#include <optional>
#include <utility>

#include "core/analysis/measure_fill.h"
#include "core/analysis/measure_seams.h"
#include "core/assembly/assemble_guidance.h"
#include "core/base/stopwatch.h"
#include "core/solver/guided_program.h"
#include "core/span/pass_through.h"
#include "core/span/refine.h"

namespace fairing {
namespace {

// Solves about the last one's solution that make the rows of G2 sides and inner constraints exact.
constexpr int kNewtonSteps = 3;

struct Solved {
  solver::QuadraticProgram program;
  solver::Solution solution;
};

// The minimiser on a layout without guidance. `aim.about` becomes what its rows were taken at.
Result<Solved> solveUnguided(const Span& span,
                             const layout::PatchLayout& layout,
                             const FillOptions& options,
                             Aim& aim) {
  const int newtonSteps = isIterated(span.plan, options) ? kNewtonSteps : 0;
  for (int k = 0;; ++k) {
    auto program = makeProgram(span.plan, layout, options.energy, aim, options.through);
    if (!program) return fail(program.error());
    auto solution = solver::solve(*program);
    if (!solution) return fail(solution.error());
    if (k == newtonSteps) return Solved{std::move(*program), std::move(*solution)};
    aim.about = solution->points;
  }
}

// The minimiser under guidance, from the one without. Guidance is looked up near the shape that it
// makes, so it is looked up again until that stands still.
Result<solver::Solution> solveGuided(const Span& span,
                                     const layout::PatchLayout& layout,
                                     const FillOptions& options,
                                     Aim aim,
                                     const solver::Points& unguided,
                                     Progress* progress) {
  const energy::Guidance& guidance = options.guidance;
  if (const auto wrong = fieldMisplaced(guidance, layout)) return fail(*wrong);
  const bool isNewton = isIterated(span.plan, options);
  const bool looksUp = guidance.isDrawn();
  solver::Points current = aim.near ? *aim.near : unguided;
  std::optional<solver::GuidedProgram> guided;
  for (int k = 0;; ++k) {
    if (progress && progress->isAbortRequested()) return fail({ErrorCode::Cancelled});
    if (!guided || isNewton) {
      if (isNewton) aim.about = current;
      const auto program = makeProgram(span.plan, layout, options.energy, aim, options.through);
      if (!program) return fail(program.error());
      guided.emplace(*program);
    }
    const auto guide = assembly::assembleGuidance(
        layout, energy::weighingOne(guidance), makePatches(layout, current));
    guided->setGuide(guide.normals, guide.points, guide.load);
    auto solution = guided->solve(guidance.lambda, guidance.gamma);
    if (!solution || (!isNewton && !looksUp) || k == energy::kLookUps) return solution;
    const double moved = (solution->points - current).rowwise().norm().maxCoeff();
    if (moved < energy::kStill * span.loop.diagonal && (!isNewton || k >= kNewtonSteps))
      return solution;
    current = solution->points;
  }
}

}  // namespace

Result<FillResult> fillOn(const Span& span,
                          const layout::PatchLayout& layout,
                          Aim aim,
                          const FillOptions& options,
                          Progress* progress) {
  Stopwatch watch;
  const auto unguided = solveUnguided(span, layout, options, aim);
  if (!unguided) return fail(unguided.error());
  solver::Solution solution = unguided->solution;
  if (options.guidance.acts()) {
    auto guided = solveGuided(span, layout, options, std::move(aim), solution.points, progress);
    if (!guided) return fail(guided.error());
    solution = std::move(*guided);
  }
  const double solveTime = watch.lap();
  FillResult result = measureSpan(span, layout, solution, options);
  result.unguided = makePatches(layout, unguided->solution.points);
  result.summary.solveTime = solveTime;
  result.summary.measureTime = watch.lap();
  result.summary.energy = solver::energy(unguided->program.stiffness, solution.points);
  return result;
}

FillResult measureSpan(const Span& span,
                       const layout::PatchLayout& layout,
                       const solver::Solution& solution,
                       const FillOptions& options) {
  FillResult result;
  result.layout = layout.kind;
  result.patches = makePatches(layout, solution.points);
  result.report = analysis::measureFill(
      span.loop, span.probe, result.patches, sideTraces(span.plan, layout), options.tolerance);
  analysis::addSeams(result.report, result.patches, seamTraces(layout));
  addInner(result.report, result.patches, options.through);
  for (std::size_t k = 0; k < span.target.sides.size(); ++k)
    result.report.sides[k].followedBy = span.target.sides[k].followedBy;
  result.reversed.assign(result.patches.size(), result.report.reversed);
  result.summary.poles = layout.pointCount;
  result.summary.unknowns = solution.unknowns;
  result.summary.constraints = solution.constraints;
  result.summary.constraintResidual = solution.residual;
  return result;
}

}  // namespace fairing
