// SPDX-License-Identifier: LGPL-2.1-or-later
// Blends from a shape and two picked edges to faces and a report, and the way of a reach slider:
// from a value to triangles.
#include <benchmark/benchmark.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "benchmarks/registered.h"
#include "core/analysis/tessellation.h"
#include "core/blend/natural_strip.h"
#include "occt/blend_shape.h"
#include "occt/edge_curve.h"
#include "text/error_text.h"

namespace fairing::benchmarks {
namespace {

constexpr int kDivisions = 32;  // of the preview, along either parameter
constexpr double kRound = 2.0 * std::numbers::pi;
constexpr double kMicrometres = 1000.0;  // in a millimetre

struct Case {
  std::string name;
  TopoDS_Shape shape;
  occt::BlendPicks picks;
};

TopoDS_Shape pairOf(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  builder.Add(compound, a);
  builder.Add(compound, b);
  return compound;
}

TopoDS_Shape face(
    const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1) {
  return BRepBuilderAPI_MakeFace(surface, u0, u1, v0, v1, 1e-7).Face();
}

TopoDS_Shape pipe(const gp_Ax3& frame, double radius) {
  return face(new Geom_CylindricalSurface(frame, radius), 0.0, kRound, 0.0, 6.0);
}

// The edge whose middle is nearest to a point.
int edgeAt(const TopoDS_Shape& shape, const Eigen::Vector3d& point) {
  const occt::ShapeIndex index(shape);
  const auto distance = [&](int edge) {
    const occt::EdgeCurve curve(index.edge(edge), occt::Direction::Forward);
    return (curve.point(0.5) - point).norm();
  };
  int nearest = 1;
  for (int edge = 2; edge <= index.edgeCount(); ++edge)
    if (distance(edge) < distance(nearest)) nearest = edge;
  return nearest;
}

Case makeCase(const std::string& name,
              const TopoDS_Shape& shape,
              const Eigen::Vector3d& from,
              const Eigen::Vector3d& to) {
  return {name, shape, {.from = {edgeAt(shape, from)}, .to = {edgeAt(shape, to)}}};
}

std::vector<Case> makeCases() {
  const gp_Ax3 low(gp_Pnt(0, 0, -14), gp_Dir(0, 0, 1));
  const gp_Ax3 high(gp_Pnt(0, 0, 8), gp_Dir(0, 0, 1));
  const double tilt = 20.0 * std::numbers::pi / 180.0;
  const gp_Dir axis(std::sin(tilt), 0, std::cos(tilt)), across(std::cos(tilt), 0, -std::sin(tilt));
  const gp_Ax3 tilted(gp_Pnt(4, 2, 8), axis, across);
  const Eigen::Vector3d end(4.0 - 9.0 * std::cos(tilt), 2.0, 8.0 + 9.0 * std::sin(tilt));
  const gp_Ax3 floor(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const gp_Ax3 wall(gp_Pnt(12, 0, 9), gp_Dir(-1, 0, 0), gp_Dir(0, -1, 0));
  const TopoDS_Shape planes =
      pairOf(face(new Geom_Plane(floor), -10, 0, 0, 20), face(new Geom_Plane(wall), -20, 0, 0, 10));
  return {makeCase("coaxial", pairOf(pipe(low, 5), pipe(high, 9)), {-5, 0, -8}, {-9, 0, 8}),
          makeCase("tilted", pairOf(pipe(low, 5), pipe(tilted, 9)), {-5, 0, -8}, end),
          makeCase("planes", planes, {0, 10, 0}, {12, 10, 9})};
}

void skip(benchmark::State& state, const Error& error) {
  state.SkipWithError(text::sentence(error).c_str());
}

void note(benchmark::State& state, const analysis::FillReport& report) {
  state.counters["angle_deg"] = report.largestAngle;
  state.counters["gap_um"] = kMicrometres * report.largestGap;
}

void wholeBlend(benchmark::State& state, const Case& c) {
  for (auto _ : state) {
    const occt::ShapeIndex index(c.shape);
    const auto blend = occt::blendShape(index, c.picks, {}, occt::ResultMode::Patches);
    if (!blend) return skip(state, blend.error());
    note(state, blend->fill.report);
  }
}

void reachSlider(benchmark::State& state, const Case& c) {
  const auto pair = occt::readChains(occt::ShapeIndex(c.shape), c.picks);
  if (!pair) return skip(state, pair.error());
  const auto strip = NaturalStrip::make(*pair, {});
  if (!strip) return skip(state, strip.error());
  double reach = 1.0;
  for (auto _ : state) {
    reach = reach < 2.0 ? reach + 0.01 : 1.0;
    const auto moved = strip->reaching({reach, 1.0});
    if (!moved) return skip(state, moved.error());
    benchmark::DoNotOptimize(analysis::tessellate(moved->patches, moved->reversed, kDivisions));
    note(state, moved->report);
  }
}

}  // namespace
}  // namespace fairing::benchmarks

int main(int argc, char** argv) {
  using namespace fairing::benchmarks;
  return runAll(argc, argv, [] {
    for (const Case& c : makeCases()) {
      add(c.name + "/blend", [=](benchmark::State& state) { wholeBlend(state, c); });
      add(c.name + "/reach_slider", [=](benchmark::State& state) { reachSlider(state, c); });
    }
  });
}
