// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/guided_span.h"

#include <utility>

#include "core/analysis/measure_guidance.h"
#include "core/assembly/assemble_guidance.h"
#include "core/base/stopwatch.h"
#include "core/span/one_pass.h"

namespace fairing {

Result<GuidedSpan> GuidedSpan::make(const FillResult& result, const FillOptions& options) {
  layout::PatchLayout layout = layoutOf(result.span->plan, result.unguided);
  const solver::Points unguided = pointsOf(layout, result.unguided);
  solver::Points latest = pointsOf(layout, result.patches);
  const auto program = makeProgram(result.span->plan,
                                   layout,
                                   options.energy,
                                   {.shape = unguided, .about = unguided, .held = {}},
                                   options.through);
  if (!program) return fail(program.error());
  return GuidedSpan(result.span, std::move(layout), *program, unguided, std::move(latest), options);
}

GuidedSpan::GuidedSpan(std::shared_ptr<const Span> span,
                       layout::PatchLayout layout,
                       const solver::QuadraticProgram& program,
                       solver::Points unguided,
                       solver::Points latest,
                       FillOptions options)
    : span_(std::move(span)),
      layout_(std::move(layout)),
      stiffness_(program.stiffness),
      program_(program),
      unguided_(std::move(unguided)),
      latest_(std::move(latest)),
      options_(std::move(options)) {}

Result<FillResult> GuidedSpan::under(const energy::Guidance& guidance, bool lookUp) {
  if (const auto wrong = energy::validate(guidance)) return fail(*wrong);
  if (const auto wrong = fieldMisplaced(guidance, layout_)) return fail(*wrong);
  Stopwatch watch;
  options_.guidance = guidance;
  if (lookUp || !isLookedUp_) {
    const solver::Points& near = guidance.isDrawn() ? latest_ : unguided_;
    const auto guide = assembly::assembleGuidance(
        layout_, energy::weighingOne(guidance), makePatches(layout_, near));
    program_.setGuide(guide.normals, guide.points, guide.load);
    isLookedUp_ = true;
  }
  const auto solution = program_.solve(guidance.lambda, guidance.gamma);
  if (!solution) return fail(solution.error());
  latest_ = solution->points;
  const double solveTime = watch.lap();
  FillResult result = measureSpan(*span_, layout_, *solution, options_);
  const auto guided = analysis::addGuidance(result.report, guidance, result.patches);
  if (!guided) return fail(guided.error());
  result.unguided = makePatches(layout_, unguided_);
  result.span = span_;
  result.summary.energy = solver::energy(stiffness_, latest_);
  result.summary.solves = 1;
  result.summary.solveTime = solveTime;
  result.summary.measureTime = watch.lap();
  result.summary.totalTime = watch.total();
  return result;
}

}  // namespace fairing
