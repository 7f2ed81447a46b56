// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/fill_trimmed.h"

#include <algorithm>

#include "core/analysis/measure_guidance.h"
#include "core/base/stopwatch.h"
#include "core/boundary/follow_support.h"
#include "core/fill/measure_trimmed.h"
#include "core/height_field/height_energy.h"
#include "core/height_field/height_guidance.h"
#include "core/height_field/height_knots.h"
#include "core/height_field/height_surface.h"
#include "core/height_field/loop_rows.h"
#include "core/height_field/trim.h"
#include "core/span/refine.h"

// The pipeline:
//
//   BoundaryLoop -> plane -> knots -> rows, energy -> heights -> surface -> report --> done
//                              ^                                               |
//                              +------- finer where a row is over its limit ---+

namespace fairing {
namespace {

using height_field::DomainGrid;
using height_field::HeightKnots;
using height_field::HeightRow;
using height_field::Heights;
using height_field::HeightSystem;

constexpr int kDegree = 5;
// One face with more control points than this is of no use to a designer.
constexpr int kMostPoles = 2400;
constexpr double kFitShare = 0.1;    // sides that are not polynomial, of the gap allowed
constexpr double kAim = 0.8;         // rows are sampled, the peaks lie between
constexpr double kFollowAim = 0.65;  // as in fill_hole.cpp
// Gauss-Newton steps on the energy of the shape itself: two do nearly everything.
constexpr int kShapeSteps = 2;
constexpr int kGaussPoints = 4;  // a span

// A hole to fill over its plane.
struct Work {
  const FillOptions& options;
  TrimmedHole hole;
  height_field::LoopRows rows;
};

Result<TrimmedHole> prepare(const boundary::BoundaryLoop& loop, const FillOptions& options) {
  const auto frame = height_field::choosePlane(loop);
  if (!frame) return fail(frame.error());
  const Tolerance& tolerance = options.tolerance;
  auto target =
      boundary::followSupports(loop,
                               kFollowAim * tolerance.angle,
                               kFollowAim * std::max(tolerance.angle, tolerance.cornerAngle));
  auto projected = height_field::projectLoop(target, *frame);
  if (const auto side = height_field::crossing(projected)) {
    const auto& crossed = loop.sides[static_cast<std::size_t>(*side)];
    return fail({.code = ErrorCode::LayoutUnfit,
                 .edge = crossed.edge,
                 .where = crossed.ribbon.curve(0.5).point,
                 .detail = "trimmed"});
  }
  auto probe = analysis::probeLoop(loop, target);
  return TrimmedHole{loop, std::move(target), std::move(probe), *frame, std::move(projected)};
}

// One solve, or a Gauss-Newton step about a height.
Result<Heights> solveOnce(const Work& work,
                          const HeightKnots& knots,
                          const DomainGrid& grid,
                          const std::vector<HeightRow>& rows,
                          const Heights* about,
                          solver::SolveSummary& summary) {
  HeightSystem system(knots.u, knots.v);
  height_field::addEnergy(system, grid, work.options.energy, about);
  if (about && work.options.guidance.acts())
    height_field::addGuidance(
        system, work.options.guidance, *about, work.hole.frame, work.hole.projected);
  for (const HeightRow& row : rows) system.addRow(row);
  auto heights = system.solve();
  ++summary.solves;
  summary.poles = summary.unknowns = knots.poleCount();
  summary.constraints = system.rows();
  if (heights) summary.energy = system.energy(*heights);
  return heights;
}

// What depends on the shape (guidance, the energy of the surface itself) starts from the parametric
// solution, or from the coarser one.
Result<Heights> solveOn(const Work& work,
                        const HeightKnots& knots,
                        const std::vector<HeightRow>& rows,
                        const Heights* coarser,
                        solver::SolveSummary& summary) {
  const DomainGrid grid(knots.u, knots.v, work.hole.projected, kGaussPoints);
  auto heights = solveOnce(work, knots, grid, rows, coarser, summary);
  const bool ofShape = height_field::isLinearised(work.options.energy);
  const int steps = ofShape ? kShapeSteps : work.options.guidance.acts() ? 1 : 0;
  double least = heights && ofShape ? height_field::shapeEnergy(grid, *heights) : 0.0;
  for (int step = 0; heights && step < steps; ++step) {
    auto next = solveOnce(work, knots, grid, rows, &*heights, summary);
    if (!next) return next;
    const double energy = ofShape ? height_field::shapeEnergy(grid, *next) : 0.0;
    // Guidance pulls against the energy, which then need not fall.
    if (energy > least && !work.options.guidance.acts()) break;
    least = energy;
    heights = std::move(next);
  }
  return heights;
}

bool isBetter(const analysis::FillReport& a, const analysis::FillReport& b) {
  return a.withinTolerance != b.withinTolerance ? a.withinTolerance : excess(a) < excess(b);
}

}  // namespace

Result<FillResult> fillTrimmed(const boundary::BoundaryLoop& loop,
                               const FillOptions& options,
                               Progress* progress) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  Stopwatch watch;
  if (progress) progress->setFraction(0.0);  // as in span_plan.cpp
  auto hole = prepare(loop, options);
  if (!hole) return fail(hole.error());
  if (const auto off = farInnerConstraint(*hole, options.through)) return fail(*off);
  Work work{options,
            std::move(*hole),
            {work.hole.target, options.through, work.hole.frame, options.tolerance}};
  const int degree = options.degree > 0 ? options.degree : kDegree;
  const int maxPoles = std::min(options.maxPoles, kMostPoles);
  HeightKnots knots = height_field::coarseKnots(work.hole.projected, degree);
  solver::SolveSummary summary;
  summary.layoutTime = watch.lap();

  std::optional<FillResult> best;
  std::optional<Heights> heights;
  for (int round = 0; round <= options.maxRefinements; ++round) {
    if (progress && progress->isAbortRequested()) return fail({ErrorCode::Cancelled});
    const auto rows = work.rows.rowsFor(knots.u, knots.v);
    auto solved = solveOn(work, knots, rows, heights ? &*heights : nullptr, summary);
    if (!solved) return fail(solved.error());
    heights = std::move(*solved);
    summary.solveTime = watch.lap();
    FillResult tried =
        measureTrimmed(work.hole, height_field::surfaceOf(*heights, work.hole.frame), options);
    summary.measureTime = watch.lap();
    tried.summary = summary;
    if (!best || isBetter(tried.report, best->report)) best = std::move(tried);
    if (progress) progress->setFraction((round + 1.0) / (options.maxRefinements + 1.0));
    const auto finer = height_field::finerKnots(knots, *heights, rows, kAim, maxPoles);
    if (!finer) break;
    knots = *finer;
  }
  best->report.fairness = trimmedFairness(work.hole, best->patches.front());
  const auto isInside = [&](std::size_t, double u, double v) {
    return work.hole.projected.contains({u, v});
  };
  const auto guided =
      analysis::addGuidance(best->report, options.guidance, best->patches, isInside);
  if (!guided) return fail(guided.error());
  best->trims = {height_field::trimBy(
      work.hole.target, work.hole.frame, kFitShare * options.tolerance.gapFor(loop.diagonal))};
  best->summary.solves = summary.solves;
  best->summary.totalTime = watch.total();
  return std::move(*best);
}

}  // namespace fairing
