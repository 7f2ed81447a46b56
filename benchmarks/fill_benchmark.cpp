// SPDX-License-Identifier: LGPL-2.1-or-later
// The whole fill, from a shape and one picked edge to faces and a report, against OpenCASCADE's
// fillings of the same holes, which are handed their edges and faces in order and measure nothing.
// Prints the times and their ratios.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "benchmarks/holes.h"
#include "benchmarks/occt_fillings.h"
#include "core/fill/fill_hole.h"
#include "occt/fill_shape.h"
#include "occt/read_boundary.h"
#include "occt/shape_index.h"
#include "text/error_text.h"

namespace fairing::benchmarks {
namespace {

const char* const kFairing = "fairing";
const char* const kFillHole = "fairing_core";
const char* const kSolve = "fairing_solve";
const char* const kMakeFilling = "make_filling";
const char* const kConstrained = "constrained_filling";

occt::Picks picksOf(const Hole& hole) {
  occt::Picks picks;
  picks.edges = {hole.edge};
  return picks;
}

std::vector<OcctSide> sidesOf(const occt::ShapeIndex& index, const boundary::BoundaryLoop& loop) {
  std::vector<OcctSide> sides;
  for (const boundary::BoundarySide& side : loop.sides)
    sides.push_back({index.edge(side.edge), index.face(side.face)});
  return sides;
}

// From the bare shape: index, loop, fill, report, faces.
void wholeFill(benchmark::State& state, const Hole& hole) {
  for (auto _ : state) {
    const occt::ShapeIndex index(hole.shape);
    const auto filled = occt::fillShape(index, picksOf(hole), {}, occt::ResultMode::Patches);
    if (!filled) return state.SkipWithError(text::sentence(filled.error()).c_str());
    state.counters["poles"] = filled->fill.summary.poles;
    state.counters["solves"] = filled->fill.summary.solves;
    state.counters["angle"] = filled->fill.report.largestAngle;
    state.counters["gap"] = filled->fill.report.largestGap;
  }
}

// The core alone: layout, solves and measurements of a loop that has been read.
void coreFill(benchmark::State& state, const boundary::BoundaryLoop& loop) {
  for (auto _ : state) {
    const auto filled = fillHole(loop, {});
    if (!filled) return state.SkipWithError(text::sentence(filled.error()).c_str());
  }
}

// Assembly and solution of the last system alone, as the core's own clock says.
void bareSolve(benchmark::State& state, const boundary::BoundaryLoop& loop) {
  for (auto _ : state) {
    const auto filled = fillHole(loop, {});
    if (!filled) return state.SkipWithError(text::sentence(filled.error()).c_str());
    state.SetIterationTime(filled->summary.solveTime);
  }
}

void occtFill(benchmark::State& state,
              const std::vector<OcctSide>& sides,
              TopoDS_Shape (*fill)(const std::vector<OcctSide>&)) {
  for (auto _ : state) {
    if (fill(sides).IsNull()) return state.SkipWithError("OpenCASCADE gave no face");
  }
}

// Prints as usual and keeps the medians, by hole and method, in milliseconds.
class MedianReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.error_occurred || run.aggregate_name != "median") continue;
      const std::string& name = run.run_name.function_name;
      const auto slash = name.find('/');
      medians_[name.substr(0, slash)][name.substr(slash + 1)] = run.GetAdjustedRealTime();
    }
  }

  void printRatios() const {
    std::printf("\n%-16s%10s%14s%14s%16s%16s%16s\n",
                "median, ms",
                kFairing,
                kSolve,
                kMakeFilling,
                kConstrained,
                "make/fairing",
                "constr/solve");
    std::vector<double> makeRatios;
    std::vector<double> solveRatios;
    for (const auto& [hole, times] : medians_) {
      const double make = ratio(times, kMakeFilling, kFairing);
      const double solve = ratio(times, kConstrained, kSolve);
      std::printf("%-16s%10.2f%14.2f%14.2f%16.2f%16.2f%16.2f\n",
                  hole.c_str(),
                  at(times, kFairing),
                  at(times, kSolve),
                  at(times, kMakeFilling),
                  at(times, kConstrained),
                  make,
                  solve);
      if (make > 0.0) makeRatios.push_back(make);
      if (solve > 0.0) solveRatios.push_back(solve);
    }
    std::printf("%-70s%16.2f%16.2f\n", "median ratio", median(makeRatios), median(solveRatios));
  }

 private:
  using Times = std::map<std::string, double>;

  static double at(const Times& times, const std::string& method) {
    const auto found = times.find(method);
    return found == times.end() ? 0.0 : found->second;
  }

  static double ratio(const Times& times, const std::string& above, const std::string& below) {
    return at(times, below) > 0.0 ? at(times, above) / at(times, below) : 0.0;
  }

  static double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  std::map<std::string, Times> medians_;
};

benchmark::internal::Benchmark* configure(benchmark::internal::Benchmark* one) {
  return one->Unit(benchmark::kMillisecond)->Repetitions(5)->ReportAggregatesOnly();
}

// Fails where the hole cannot be read: a benchmark of nothing is none.
bool registerHole(const Hole& hole) {
  const occt::ShapeIndex index(hole.shape);
  const auto loop = occt::readBoundary(index, picksOf(hole));
  if (!loop) {
    std::fprintf(stderr, "%s: %s\n", hole.name.c_str(), text::sentence(loop.error()).c_str());
    return false;
  }
  const std::vector<OcctSide> sides = sidesOf(index, *loop);
  const auto name = [&](const char* method) { return hole.name + "/" + method; };
  configure(benchmark::RegisterBenchmark(name(kFairing).c_str(),
                                         [=](benchmark::State& state) { wholeFill(state, hole); }));
  configure(benchmark::RegisterBenchmark(name(kFillHole).c_str(),
                                         [=](benchmark::State& state) { coreFill(state, *loop); }));
  configure(benchmark::RegisterBenchmark(name(kSolve).c_str(), [=](benchmark::State& state) {
    bareSolve(state, *loop);
  }))->UseManualTime();
  configure(benchmark::RegisterBenchmark(name(kMakeFilling).c_str(), [=](benchmark::State& state) {
    occtFill(state, sides, makeFilling);
  }));
  configure(benchmark::RegisterBenchmark(name(kConstrained).c_str(), [=](benchmark::State& state) {
    occtFill(state, sides, constrainedFilling);
  }));
  return true;
}

}  // namespace
}  // namespace fairing::benchmarks

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  bool complete = true;
  for (const auto& hole : fairing::benchmarks::makeHoles())
    complete = fairing::benchmarks::registerHole(hole) && complete;
  fairing::benchmarks::MedianReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.printRatios();
  return complete ? 0 : 1;
}
