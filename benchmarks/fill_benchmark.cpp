// SPDX-License-Identifier: LGPL-2.1-or-later
// The whole fill, from a shape and one picked edge to faces and a report, against OpenCASCADE's
// fillings of the same holes. These are handed their edges and faces in order and measure nothing;
// what they leave is measured afterwards by the same report, outside the clock.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <vector>

#include "benchmarks/comparison.h"
#include "benchmarks/holes.h"
#include "benchmarks/occt_fillings.h"
#include "benchmarks/registered.h"
#include "core/fill/fill_hole.h"
#include "occt/fill_shape.h"
#include "occt/measure_shape.h"
#include "occt/read_boundary.h"
#include "occt/shape_index.h"
#include "text/error_text.h"

namespace fairing::benchmarks {
namespace {

constexpr double kMicrometres = 1000.0;  // in a millimetre

occt::Picks picksOf(const Hole& hole) {
  occt::Picks picks;
  picks.edges = {hole.edge};
  return picks;
}

void note(benchmark::State& state, const analysis::FillReport& report) {
  state.counters[kAngle] = report.largestAngle;
  state.counters[kGap] = kMicrometres * report.largestGap;
}

void skip(benchmark::State& state, const Error& error) {
  state.SkipWithError(text::sentence(error).c_str());
}

// From the bare shape: index, loop, solves, report, faces.
void wholeFill(benchmark::State& state, const Hole& hole) {
  for (auto _ : state) {
    const occt::ShapeIndex index(hole.shape);
    const auto filled = occt::fillShape(index, picksOf(hole), {}, occt::ResultMode::Patches);
    if (!filled) return skip(state, filled.error());
    note(state, filled->fill.report);
  }
}

// Assembly and solution of the last system alone, as the core's own clock says.
void bareSolve(benchmark::State& state, const boundary::BoundaryLoop& loop) {
  for (auto _ : state) {
    const auto filled = fillHole(loop, {});
    if (!filled) return skip(state, filled.error());
    state.SetIterationTime(filled->summary.solveTime);
  }
}

using OcctFilling = TopoDS_Shape (*)(const std::vector<OcctSide>&);

void occtFill(benchmark::State& state,
              const boundary::BoundaryLoop& loop,
              const std::vector<OcctSide>& sides,
              OcctFilling fill) {
  TopoDS_Shape faces;
  for (auto _ : state) {
    faces = fill(sides);
    if (faces.IsNull()) return state.SkipWithError("OpenCASCADE gave no face");
  }
  const auto report = occt::measureShape(loop, faces, {});
  if (!report) return skip(state, report.error());
  note(state, *report);
}

// False where the hole cannot be read: a benchmark of nothing is none.
bool addHole(const Hole& hole) {
  const occt::ShapeIndex index(hole.shape);
  const auto loop = occt::readBoundary(index, picksOf(hole));
  if (!loop) {
    std::fprintf(stderr, "%s: %s\n", hole.name.c_str(), text::sentence(loop.error()).c_str());
    return false;
  }
  std::vector<OcctSide> sides;
  for (const boundary::BoundarySide& side : loop->sides)
    sides.push_back({index.edge(side.edge), index.face(side.face)});

  using benchmark::State;
  add(hole.name + "/" + kFairing, [=](State& state) { wholeFill(state, hole); });
  add(hole.name + "/" + kSolve, [=](State& state) { bareSolve(state, *loop); })->UseManualTime();
  add(hole.name + "/" + kMakeFilling,
      [=](State& state) { occtFill(state, *loop, sides, makeFilling); });
  if (suitsConstrainedFilling(sides))
    add(hole.name + "/" + kConstrained,
        [=](State& state) { occtFill(state, *loop, sides, constrainedFilling); });
  return true;
}

}  // namespace
}  // namespace fairing::benchmarks

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  bool complete = true;
  for (const auto& hole : fairing::benchmarks::makeHoles())
    complete = fairing::benchmarks::addHole(hole) && complete;
  fairing::benchmarks::Comparison comparison;
  benchmark::RunSpecifiedBenchmarks(&comparison);
  return complete && comparison.complete() ? 0 : 1;
}
