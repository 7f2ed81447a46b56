// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Surfaces whose curvatures do not change along themselves come back from their border alone.
#include <gmock/gmock.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <numbers>

#include "core/assembly/assemble_shape_energy.h"
#include "core/shape_energy/minimum_variation.h"
#include "occt/blends.h"
#include "occt/fill_shape.h"
#include "occt/from_occt.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;

constexpr double kRound = 2.0 * std::numbers::pi;
// Of the diagonal: distance to the true surface.
constexpr double kNear = 1e-4;
// What is left of the thin plate's energy.
constexpr double kLeft = 1e-6;

FillOptions minimumVariation() {
  FillOptions options;
  options.energy = EnergyKind::MinimumVariation;
  return options;
}

ShapeFill filled(const TopoDS_Shape& shape, const std::vector<int>& edges) {
  auto fill =
      fillShape(ShapeIndex(shape), {.edges = edges}, minimumVariation(), ResultMode::Patches);
  EXPECT_TRUE(fill.has_value());
  return fill ? std::move(*fill) : ShapeFill{};
}

double largestDistance(const ShapeFill& fill, const Handle(Geom_Surface) & surface) {
  double largest = 0.0;
  for (const Vector3d& p : testing::pointsOf(fill, 12)) {
    const GeomAPI_ProjectPointOnSurf foot(gp_Pnt(p.x(), p.y(), p.z()), surface);
    largest = std::max(largest, foot.LowerDistance());
  }
  return largest;
}

void expectThat(const ShapeFill& fill, const Handle(Geom_Surface) & surface, const char* name) {
  SCOPED_TRACE(name);
  const double diagonal = fill.fill.report.diagonal;
  const solver::ShapeHistory& history = fill.fill.summary.shape;
  EXPECT_TRUE(fill.fill.report.withinTolerance);
  EXPECT_EQ(history.end, solver::ShapeEnd::Converged);
  EXPECT_LT(largestDistance(fill, surface), kNear * diagonal);
  const double energy = assembly::shapeEnergyOf(
      fill.fill.patches, shape_energy::MinimumVariation(1e-4 / diagonal), 8);
  EXPECT_LT(energy, kLeft * history.start) << "from " << history.start;
}

TEST(KnownSurfaces, ComeBackInsideFourSides) {
  const struct {
    const char* name;
    Handle(Geom_Surface) surface;
    std::vector<double> u, v;
  } kCases[] = {
      {"sphere",
       new Geom_SphericalSurface(upright(), 10.0),
       {0, 0.4, 1.2, 1.6},
       {0, 0.3, 0.9, 1.2}},
      {"cylinder", new Geom_CylindricalSurface(upright(), 5.0), {0, 0.5, 2.0, 2.5}, {0, 2, 8, 10}},
      {"cone", new Geom_ConicalSurface(upright(), 0.4, 6.0), {0, 0.5, 1.7, 2.2}, {0, 2, 8, 10}},
      {"outer torus",
       new Geom_ToroidalSurface(upright(), 20.0, 6.0),
       {0, 0.2, 0.7, 0.9},
       {-0.9, -0.5, 0.8, 1.2}},
      {"saddle of a torus",
       new Geom_ToroidalSurface(upright(), 20.0, 6.0),
       {0, 0.3, 1.0, 1.3},
       {1.8, 2.2, 3.6, 4.0}},
  };
  for (const auto& c : kCases) {
    const TopoDS_Shape shape = grid(c.surface, c.u, c.v, {{1, 1}});
    expectThat(filled(shape, innerFreeEdges(ShapeIndex(shape))), c.surface, c.name);
  }
}

// An o-grid: the edge is where a cylinder cuts the sphere off its middle.
TEST(KnownSurfaces, SphereComesBackInARoundHole) {
  const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(upright(), 10.0);
  const TopoDS_Shape face =
      BRepBuilderAPI_MakeFace(sphere, 0.0, 0.5 * kRound, -0.9, 0.9, 1e-7).Face();
  const gp_Ax2 across(gp_Pnt(0, 0, 1), gp_Dir(0, 1, 0));
  const TopoDS_Shape holed =
      BRepAlgoAPI_Cut(face, BRepPrimAPI_MakeCylinder(across, 3.0, 20.0).Shape()).Shape();
  const ShapeFill fill = filled(holed, edgesNear(ShapeIndex(holed), {{0, 9.2, 4}}));
  EXPECT_EQ(fill.fill.layout, LayoutKind::OGrid);
  expectThat(fill, sphere, "round hole");
}

TEST(KnownSurfaces, ComeBackBetweenTheirTwoEnds) {
  const struct {
    const char* name;
    Handle(Geom_Surface) surface;
    std::vector<double> u, v;
    Cell gap;
  } kCases[] = {
      {"cylinder",
       new Geom_CylindricalSurface(upright(), 5.0),
       {0, kRound},
       {-9, -3, 4, 9},
       {0, 1}},
      {"cone", new Geom_ConicalSurface(upright(), 0.4, 6.0), {0, kRound}, {0, 3, 9, 12}, {0, 1}},
      {"sphere",
       new Geom_SphericalSurface(upright(), 10.0),
       {0, kRound},
       {-0.9, -0.3, 0.4, 0.9},
       {0, 1}},
      {"torus round its tube",
       new Geom_ToroidalSurface(upright(), 20.0, 6.0),
       {0, kRound},
       {0.2, 0.8, 1.8, 2.4},
       {0, 1}},
      {"torus along its tube",
       new Geom_ToroidalSurface(upright(), 20.0, 6.0),
       {0, 0.4, 1.2, 1.6},
       {0, kRound},
       {1, 0}},
  };
  for (const auto& c : kCases) {
    const TopoDS_Shape shape = grid(c.surface, c.u, c.v, {c.gap}, Joint::Loose);
    const bool alongV = c.gap.second == 1;
    const double half = 0.5 * kRound;
    const auto place = [&](double at) {
      return fromOcct(alongV ? c.surface->Value(half, at) : c.surface->Value(at, half));
    };
    const std::vector<double>& across = alongV ? c.v : c.u;
    const ShapeFill blend = blended(shape,
                                    between(shape, place(across[1]), place(across[2])),
                                    ResultMode::Patches,
                                    {.fill = minimumVariation()});
    expectThat(blend, c.surface, c.name);
  }
}

}  // namespace
}  // namespace fairing::occt
