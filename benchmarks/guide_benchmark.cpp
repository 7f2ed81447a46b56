// SPDX-License-Identifier: LGPL-2.1-or-later
// The way of a guidance slider, and of a handle that is dragged: from a value to faces, a report
// and triangles.
#include <benchmark/benchmark.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <string>

#include "benchmarks/graph.h"
#include "benchmarks/holes.h"
#include "benchmarks/registered.h"
#include "core/analysis/tessellation.h"
#include "occt/guide_live.h"
#include "text/error_text.h"

namespace fairing::benchmarks {
namespace {

constexpr int kDivisions = 32;  // of the preview, along either parameter

struct Case {
  std::string name, hole;
  LayoutKind layout;
  EnergyKind energy;
  int degree;
  int refinements;
};

const Case kCases[] = {
    {"patch_7x7", "bezier", LayoutKind::Quad, EnergyKind::ThinPlate, 7, 0},
    {"star_5_of_9x9", "wavy_pentagon", LayoutKind::Star, EnergyKind::ThinPlate, 9, 0},
    {"patch_as_filled", "bump", LayoutKind::Auto, FillOptions{}.energy, 0, 6},
    {"star_as_filled", "wavy_pentagon", LayoutKind::Auto, FillOptions{}.energy, 0, 6},
};

// Eight of the nine pieces of a bicubic Bezier sheet: the borders are polynomials, so a patch of
// one span can meet them.
Hole bezierHole() {
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      poles(i + 1, j + 1) = gp_Pnt(20.0 * i, 20.0 * j, (i * 7 + j * 5) % 4 * 4.0 - 6.0);
  const Handle(Geom_Surface) sheet = new Geom_BezierSurface(poles);
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != 1 || j != 1)
        sewing.Add(
            BRepBuilderAPI_MakeFace(sheet, i / 3.0, (i + 1) / 3.0, j / 3.0, (j + 1) / 3.0, 1e-6));
  sewing.Perform();
  const TopoDS_Shape& shape = sewing.SewedShape();
  return {"bezier", shape, freeEdgeAt(shape, sheet->Value(0.5, 1.0 / 3.0))};
}

Hole holeNamed(const std::string& name) {
  if (name == "bezier") return bezierHole();
  for (const Hole& hole : makeHoles())
    if (hole.name == name) return hole;
  return {};
}

Result<occt::ShapeFill> filled(const Case& c) {
  const Hole hole = holeNamed(c.hole);
  FillOptions options;
  options.layout = c.layout;
  options.energy = c.energy;
  options.degree = c.degree;
  options.maxRefinements = c.refinements;
  return occt::fillShape(
      occt::ShapeIndex(hole.shape), {.edges = {hole.edge}}, options, occt::ResultMode::Patches);
}

// A handle in the middle of the first patch that leans out of its normal.
energy::Guidance leaning(const FillResult& fill) {
  const spline::BsplineSurface& patch = fill.patches.front();
  const auto jet =
      patch.jet(0.5 * (patch.u.first() + patch.u.last()), 0.5 * (patch.v.first() + patch.v.last()));
  energy::Guidance guidance;
  guidance.lambda = 1.0;
  guidance.handles = {{jet.point,
                       jet.normalVector().normalized() + 0.3 * jet.u.normalized(),
                       1.0,
                       0.2 * fill.report.diagonal}};
  return guidance;
}

void slide(benchmark::State& state, const Case& c, bool lookUp) {
  const auto fill = filled(c);
  if (!fill) return state.SkipWithError(text::sentence(fill.error()).c_str());
  energy::Guidance guidance = leaning(fill->fill);
  double solving = 0.0, measuring = 0.0;
  for (auto _ : state) {
    guidance.lambda = guidance.lambda < 500.0 ? 1.1 * guidance.lambda : 1.0;
    if (lookUp) guidance.handles[0].normal += 0.01 * Eigen::Vector3d::UnitX();
    const auto moved = occt::guiding(*fill, guidance, lookUp);
    if (!moved) return state.SkipWithError(text::sentence(moved.error()).c_str());
    benchmark::DoNotOptimize(
        analysis::tessellate(moved->fill.patches, moved->fill.reversed, kDivisions));
    solving += moved->fill.summary.solveTime;
    measuring += moved->fill.summary.measureTime;
  }
  const auto perStep = benchmark::Counter::kAvgIterations;
  state.counters["solve_ms"] = benchmark::Counter(1e3 * solving, perStep);
  state.counters["measure_ms"] = benchmark::Counter(1e3 * measuring, perStep);
  state.counters["poles"] = fill->fill.summary.poles;
  state.counters["patches"] = static_cast<double>(fill->fill.patches.size());
}

}  // namespace
}  // namespace fairing::benchmarks

int main(int argc, char** argv) {
  using namespace fairing::benchmarks;
  return runAll(argc, argv, [] {
    for (const Case& c : kCases) {
      add(c.name + "/slider", [=](benchmark::State& state) { slide(state, c, false); });
      add(c.name + "/handle", [=](benchmark::State& state) { slide(state, c, true); });
    }
  });
}
