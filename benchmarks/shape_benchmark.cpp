// SPDX-License-Identifier: LGPL-2.1-or-later
// The way from the thin plate to the minimum of every energy of the shape, on the knots that a fill
// starts with: how many steps, and what they are spent on.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "benchmarks/holes.h"
#include "benchmarks/registered.h"
#include "core/layout/layouts.h"
#include "core/shape_energy/mean_curvature_gradient.h"
#include "core/shape_energy/minimum_variation.h"
#include "core/shape_energy/total_curvature.h"
#include "core/span/shape_descent.h"
#include "core/span/span_hole.h"
#include "occt/read_boundary.h"
#include "text/error_text.h"

namespace fairing::benchmarks {
namespace {

struct Energy {
  std::string name;
  std::shared_ptr<const shape_energy::ShapeEnergy> energy;
  double anchor;
};

// Three sides, four on a freeform sheet, five and six, and a circle (o-grid).
const std::string kHoles[] = {
    "sphere_octant", "bump", "wavy_pentagon", "wavy_hexagon", "round_hole"};
constexpr double kDensity = 3.0, kFitShare = 1e-5;
constexpr int kMostPolesAlong = 24, kPoints = 7, kMostSteps = 30;
constexpr double kWorthAStep = 1e-3;

std::vector<Energy> energies(double diagonal) {
  return {{"mean_curvature_gradient", std::make_shared<shape_energy::MeanCurvatureGradient>(), 1e4},
          {"minimum_variation",
           std::make_shared<shape_energy::MinimumVariation>(shape_energy::kUmbilicShare / diagonal),
           1e4},
          {"total_curvature", std::make_shared<shape_energy::TotalCurvature>(), 1e6}};
}

void descend(benchmark::State& state, const Hole& hole, std::size_t which) {
  const auto loop = occt::readBoundary(occt::ShapeIndex(hole.shape), {.edges = {hole.edge}});
  if (!loop) return state.SkipWithError(text::sentence(loop.error()).c_str());
  const double fit = kFitShare * loop->diagonal;
  const auto plan = layout::planLayout(*loop, LayoutKind::Auto);
  if (!plan) return state.SkipWithError(text::sentence(plan.error()).c_str());
  const auto layout = layout::coarseLayout(
      *plan, layout::makeLayout(*plan, {.fitTolerance = fit}), {kDensity, fit, kMostPolesAlong});
  const auto program = makeProgram(*plan, layout, EnergyKind::ThinPlate);
  if (!program) return state.SkipWithError(text::sentence(program.error()).c_str());
  const auto plate = solver::solve(*program);
  if (!plate) return state.SkipWithError(text::sentence(plate.error()).c_str());
  const Energy chosen = energies(loop->diagonal)[which];
  StageTimes times;
  int steps = 0;
  for (auto _ : state) {
    ShapeDescent descent(layout,
                         *chosen.energy,
                         *program,
                         plate->points,
                         loop->diagonal,
                         {0.0, chosen.anchor},
                         kPoints);
    solver::Points points = plate->points;
    for (steps = 0; steps < kMostSteps; ++steps) {
      const ShapeStep step = descent.step(points);
      if (!step.fell || step.before - (step.energy + step.anchor) < kWorthAStep * step.before)
        break;
    }
    times = descent.times();
  }
  const double all = times.assembly + times.factorisation + times.evaluation;
  state.counters["steps"] = steps;
  state.counters["points"] = layout.pointCount;
  state.counters["assembly"] = times.assembly / all;
  state.counters["factorisation"] = times.factorisation / all;
  state.counters["evaluation"] = times.evaluation / all;
}

}  // namespace
}  // namespace fairing::benchmarks

int main(int argc, char** argv) {
  using namespace fairing::benchmarks;
  return runAll(argc, argv, [] {
    for (const Hole& hole : makeHoles())
      for (const std::string& name : kHoles) {
        if (hole.name != name) continue;
        for (std::size_t k = 0; k < energies(1.0).size(); ++k)
          add(name + "/" + energies(1.0)[k].name,
              [=](benchmark::State& state) { descend(state, hole, k); });
      }
  });
}
