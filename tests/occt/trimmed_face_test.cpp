// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/trimmed_face.h"

#include <gmock/gmock.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "occt/fill_shape.h"
#include "occt/measure_shape.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;

/// The waved sheet with a round hole in its middle.
TopoDS_Shape sheetWithRoundHole() {
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(wavedSheet(), 1e-6).Shape();
  const gp_Ax2 axis(gp_Pnt(15, 14, -20), gp_Dir(0.05, -0.03, 1.0));
  return BRepAlgoAPI_Cut(face, BRepPrimAPI_MakeCylinder(axis, 6.0, 40.0).Shape()).Shape();
}

/// 4 x 4 cells of the waved sheet without three of the inner ones: an L of eight edges.
TopoDS_Shape sheetWithAngularHole() {
  const Handle(Geom_Surface) surface = wavedSheet();
  double u0, u1, v0, v1;
  surface->Bounds(u0, u1, v0, v1);
  const auto parts = [](double a, double b) {
    return std::vector{a, a + 0.22 * (b - a), a + 0.5 * (b - a), a + 0.79 * (b - a), b};
  };
  return grid(surface, parts(u0, u1), parts(v0, v1), {{1, 1}, {2, 1}, {1, 2}});
}

ShapeFill filled(const TopoDS_Shape& shape, const Picks& picks, ResultMode mode) {
  FillOptions options;
  options.layout = LayoutKind::Trimmed;
  options.energy = EnergyKind::ThinPlate;
  auto result = fillShape(ShapeIndex(shape), picks, options, mode);
  EXPECT_TRUE(result.has_value()) << (result ? 0 : int(result.error().code));
  return result ? *result : ShapeFill{};
}

Picks holeOf(const TopoDS_Shape& shape) {
  return {.edges = innerFreeEdges(ShapeIndex(shape))};
}

struct Hole {
  const char* name;
  TopoDS_Shape (*shape)();
};
class TrimmedFace : public ::testing::TestWithParam<Hole> {};

TEST_P(TrimmedFace, IsValidAndLooksTheWayItsNeighboursDo) {
  const TopoDS_Shape shape = GetParam().shape();
  for (const TopoDS_Shape& base : {shape, TopoDS_Shape(shape.Reversed())}) {
    const ShapeFill fill = filled(base, holeOf(base), ResultMode::Patches);
    ASSERT_EQ(fill.shape.ShapeType(), TopAbs_FACE);
    EXPECT_TRUE(BRepCheck_Analyzer(fill.shape).IsValid());
    EXPECT_TRUE(fill.fill.report.withinTolerance);
    const auto report = measureShape(fill.loop, fill.shape, {});
    ASSERT_TRUE(report.has_value());
    EXPECT_FALSE(report->reversed);
    EXPECT_NEAR(report->largestGap, fill.fill.report.largestGap, 1e-7 * fill.loop.diagonal);
  }
}

TEST_P(TrimmedFace, ClaimsNoMoreThanIsMeasured) {
  const TopoDS_Shape shape = GetParam().shape();
  const ShapeFill fill = filled(shape, holeOf(shape), ResultMode::Patches);
  double apart = 0.0;
  for (const boundary::Corner& corner : fill.loop.corners) apart = std::max(apart, corner.gap);
  const double gap = fill.fill.report.largestGap;
  // The report's places are not the edges': a third more, and what the kernel itself adds.
  EXPECT_LE(largestTolerance(fill.shape), std::max(1.0001e-7, 1.34 * gap + apart));
}

TEST_P(TrimmedFace, SewsIntoTheBase) {
  const TopoDS_Shape shape = GetParam().shape();
  const Picks picks = holeOf(shape);
  const ShapeFill fill = filled(shape, picks, ResultMode::Base);
  EXPECT_TRUE(BRepCheck_Analyzer(fill.shape).IsValid());
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(fill.shape, TopAbs_EDGE, TopAbs_FACE, faces);
  int free = 0;
  for (int i = 1; i <= faces.Extent(); ++i)
    if (faces(i).Extent() == 1) ++free;
  int before = 0;
  const ShapeIndex index(shape);
  for (int edge = 1; edge <= index.edgeCount(); ++edge)
    if (index.uses(edge).size() == 1) ++before;
  EXPECT_EQ(free, before - int(picks.edges.size()));
}

TEST_P(TrimmedFace, HasTheAreaOfWhatIsMissing) {
  const TopoDS_Shape shape = GetParam().shape();
  const TopoDS_Shape whole = BRepBuilderAPI_MakeFace(wavedSheet(), 1e-6).Shape();
  const double missing = area(whole) - area(shape);
  const ShapeFill fill = filled(shape, holeOf(shape), ResultMode::Patches);
  EXPECT_NEAR(area(fill.shape), missing, 2e-3 * missing);
  EXPECT_NEAR(fill.fill.report.fairness.area, missing, 3e-3 * missing);
}

INSTANTIATE_TEST_SUITE_P(OnWaves,
                         TrimmedFace,
                         ::testing::Values(Hole{"Round", sheetWithRoundHole},
                                           Hole{"Angular", sheetWithAngularHole}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(TrimmedFaceOfASolid, ClosesItAgain) {
  const TopoDS_Shape sharp = box(40, 40, 40);
  const ShapeIndex corners(sharp);
  BRepFilletAPI_MakeFillet fillet(sharp);
  for (const int edge : edgesNear(corners, {{20, 0, 0}, {0, 20, 0}, {0, 0, 20}}))
    fillet.Add(6.0, corners.edge(edge));
  const TopoDS_Shape solid = fillet.Shape();
  const ShapeIndex index(solid);
  int corner = 0;
  for (int face = 1; face <= index.faceCount(); ++face)
    if (BRep_Tool::Surface(index.face(face))->DynamicType()->Name() ==
        std::string("Geom_SphericalSurface"))
      corner = face;
  ASSERT_GT(corner, 0);
  const ShapeFill fill = filled(solid, {.faces = {corner}}, ResultMode::Base);
  EXPECT_EQ(fill.shape.ShapeType(), TopAbs_SOLID);
  EXPECT_TRUE(BRepCheck_Analyzer(fill.shape).IsValid());
  EXPECT_NEAR(volume(fill.shape), volume(solid), 1e-4 * volume(solid));
}

}  // namespace
}  // namespace fairing::occt
