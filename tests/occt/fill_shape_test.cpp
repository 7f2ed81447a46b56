// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/fill_shape.h"

#include <gmock/gmock.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GeomAbs_SurfaceType.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "occt/find_holes.h"
#include "occt/measure_shape.h"
#include "occt/read_boundary.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;

ShapeFill filled(const TopoDS_Shape& shape,
                 const Picks& picks,
                 ResultMode mode = ResultMode::Patches) {
  const ShapeIndex index(shape);
  auto result = fillShape(index, picks, {}, mode);
  EXPECT_TRUE(result.has_value()) << (result ? 0 : int(result.error().code));
  return result ? *result : ShapeFill{};
}

Picks holePicks(const TopoDS_Shape& shape) {
  return {.edges = innerFreeEdges(ShapeIndex(shape))};
}

/// Corner face of a box whose three edges at a corner are rounded with the given radii.
struct RoundedCorner {
  TopoDS_Shape solid;
  int cornerFace = 0;
};

RoundedCorner roundedCorner(double a, double b, double c) {
  const TopoDS_Shape sharp = box(40, 40, 40);
  const ShapeIndex index(sharp);
  BRepFilletAPI_MakeFillet fillet(sharp);
  const std::vector<int> edges = edgesNear(index, {{20, 0, 0}, {0, 20, 0}, {0, 0, 20}});
  fillet.Add(a, index.edge(edges[0]));
  fillet.Add(b, index.edge(edges[1]));
  fillet.Add(c, index.edge(edges[2]));
  RoundedCorner result{fillet.Shape()};
  const ShapeIndex rounded(result.solid);
  for (int face = 1; face <= rounded.faceCount(); ++face) {
    const auto type = BRepAdaptor_Surface(rounded.face(face)).GetType();
    if (type != GeomAbs_Plane && type != GeomAbs_Cylinder) result.cornerFace = face;
  }
  return result;
}

TEST(FillShape, GivesAValidFaceThatLiesExactlyOnPolynomialEdges) {
  const TopoDS_Shape shape = sheetWithHole();
  const ShapeFill fill = filled(shape, holePicks(shape));
  ASSERT_EQ(fill.shape.ShapeType(), TopAbs_FACE);
  EXPECT_TRUE(BRepCheck_Analyzer(fill.shape).IsValid());
  EXPECT_TRUE(fill.fill.report.withinTolerance);
  // Where the edges' own ends are apart, no surface meets both; nothing is added to that.
  double apart = 0.0;
  for (const boundary::Corner& corner : fill.loop.corners) apart = std::max(apart, corner.gap);
  EXPECT_LT(apart, 1e-8);
  EXPECT_LT(fill.fill.report.largestGap, apart + 1e-12 * fill.loop.diagonal);
  EXPECT_LE(largestTolerance(fill.shape), 1.0001e-7);
}

TEST(FillShape, GivesTheSurfaceOfTheCorePoleByPole) {
  const TopoDS_Shape shape = sheetWithHole();
  const ShapeFill fill = filled(shape, holePicks(shape));
  const auto surface =
      Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(fill.shape)));
  ASSERT_FALSE(surface.IsNull());
  const spline::BsplineSurface& patch = fill.fill.patches.front();
  ASSERT_EQ(surface->NbUPoles(), patch.u.poleCount());
  ASSERT_EQ(surface->NbVPoles(), patch.v.poleCount());
  EXPECT_EQ(surface->UDegree(), patch.u.degree());
  for (double u : {0.0, 0.3, 1.0}) {
    for (double v : {0.0, 0.6, 1.0}) {
      const double s = patch.u.first() + u * (patch.u.last() - patch.u.first());
      const double t = patch.v.first() + v * (patch.v.last() - patch.v.first());
      const gp_Pnt p = surface->Value(s, t);
      EXPECT_LT((Vector3d(p.X(), p.Y(), p.Z()) - patch.evaluate(s, t)).norm(), 1e-12);
    }
  }
}

TEST(FillShape, OrientsTheFaceLikeItsNeighbours) {
  for (const TopoDS_Shape& shape : {sheetWithHole(), TopoDS_Shape(sheetWithHole().Reversed())}) {
    const ShapeFill fill = filled(shape, holePicks(shape));
    const auto report = measureShape(fill.loop, fill.shape, {});
    ASSERT_TRUE(report.has_value());
    EXPECT_FALSE(report->reversed);
  }
}

TEST(FillShape, SewsIntoAnOpenSheetWithoutFreeEdgesAtTheHole) {
  const TopoDS_Shape shape = sheetWithHole();
  const Picks picks = holePicks(shape);
  const ShapeFill fill = filled(shape, picks, ResultMode::Base);
  EXPECT_EQ(fill.shape.ShapeType(), TopAbs_SHELL);
  EXPECT_TRUE(BRepCheck_Analyzer(fill.shape).IsValid());
  const ShapeIndex index(fill.shape);
  EXPECT_EQ(index.faceCount(), 9);
  const std::vector<Hole> holes = findHoles(index);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_EQ(holes[0].edges.size(), 12u);
  EXPECT_LE(largestTolerance(fill.shape), 1e-6);
}

TEST(FillShape, ClosesASolidWhoseFaceIsReplaced) {
  const TopoDS_Shape shape = box(10, 20, 30);
  for (int face = 1; face <= 6; ++face) {
    const ShapeFill fill =
        filled(shape, {.faces = {face}, .continuity = Continuity::G0}, ResultMode::Base);
    ASSERT_FALSE(fill.shape.IsNull());
    EXPECT_EQ(fill.shape.ShapeType(), TopAbs_SOLID);
    EXPECT_TRUE(BRepCheck_Analyzer(fill.shape).IsValid());
    EXPECT_NEAR(volume(fill.shape), 6000.0, 1e-6);
  }
}

TEST(FillShape, ReplacesTheCornerOfARoundedBox) {
  const RoundedCorner corner = roundedCorner(4, 6, 9);
  ASSERT_GT(corner.cornerFace, 0);
  const ShapeFill fill = filled(corner.solid, {.faces = {corner.cornerFace}}, ResultMode::Base);
  ASSERT_EQ(fill.loop.sides.size(), 4u);
  EXPECT_EQ(fill.shape.ShapeType(), TopAbs_SOLID);
  EXPECT_TRUE(BRepCheck_Analyzer(fill.shape).IsValid());
  EXPECT_TRUE(fill.fill.report.withinTolerance);
  EXPECT_NEAR(volume(fill.shape), volume(corner.solid), 1e-3 * volume(corner.solid));
}

TEST(FillShape, SewsThePlaceOfALooseFace) {
  const Handle(Geom_Surface) surface = new Geom_SphericalSurface(gp_Ax3(), 12.0);
  const TopoDS_Shape loose =
      grid(surface, {0.2, 0.7, 1.2, 1.7}, {-0.6, -0.1, 0.4, 0.9}, {}, Joint::Loose);
  const ShapeFill fill = filled(loose, {.faces = {5}}, ResultMode::Base);
  ASSERT_FALSE(fill.shape.IsNull());
  EXPECT_TRUE(BRepCheck_Analyzer(fill.shape).IsValid());
  EXPECT_EQ(ShapeIndex(fill.shape).faceCount(), 9);
  const std::vector<Hole> holes = findHoles(ShapeIndex(fill.shape));
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_EQ(holes[0].edges.size(), 12u);
}

TEST(FillShape, LeavesALoneEdgeUnsewn) {
  TopoDS_Shape sheet = grid(new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)),
                            {0, 10, 20, 30},
                            {0, 10, 20, 30},
                            {{1, 1}, {1, 2}});
  const TopoDS_Shape shape =
      compound({sheet, BRepBuilderAPI_MakeEdge(gp_Pnt(10, 20, 0), gp_Pnt(20, 20, 0)).Shape()});
  const ShapeIndex index(shape);
  const ShapeFill fill =
      filled(shape, {.edges = edgesNear(index, {{15, 20, 0}})}, ResultMode::Base);
  ASSERT_FALSE(fill.shape.IsNull());
  EXPECT_TRUE(BRepCheck_Analyzer(fill.shape).IsValid());
  EXPECT_NEAR(area(fill.shape), 800.0, 1e-6);
}

TEST(FillShape, MakesAShellOnRequest) {
  const TopoDS_Shape shape = sheetWithHole();
  const ShapeFill fill = filled(shape, holePicks(shape), ResultMode::Shell);
  EXPECT_EQ(fill.shape.ShapeType(), TopAbs_SHELL);
  EXPECT_EQ(ShapeIndex(fill.shape).faceCount(), 1);
}

TEST(FillShape, RefusesBadOptionsBeforeAnythingElse) {
  FillOptions options;
  options.tolerance.gap = -1.0;
  const auto result = fillShape(ShapeIndex(box(1, 2, 3)), {}, options, ResultMode::Patches);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::ToleranceNotPositive);
}

TEST(FillShape, CanBeCancelled) {
  Progress progress;
  progress.requestAbort();
  const TopoDS_Shape shape = sheetWithHole();
  const auto result =
      fillShape(ShapeIndex(shape), holePicks(shape), {}, ResultMode::Patches, &progress);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
}

TEST(MeasureShape, AgreesWithTheMeasurementOfTheCore) {
  const TopoDS_Shape shape = grid(new Geom_ToroidalSurface(gp_Ax3(), 20.0, 6.0),
                                  {0.2, 0.7, 1.2, 1.7},
                                  {1.0, 1.5, 2.1, 2.8},
                                  {{1, 1}});
  const ShapeFill fill = filled(shape, holePicks(shape));
  const auto report = measureShape(fill.loop, fill.shape, {});
  ASSERT_TRUE(report.has_value());
  EXPECT_NEAR(report->largestGap, fill.fill.report.largestGap, 1e-9);
  EXPECT_NEAR(report->largestAngle, fill.fill.report.largestAngle, 1e-4);
  EXPECT_EQ(report->withinTolerance, fill.fill.report.withinTolerance);
}

TEST(MeasureShape, FindsTheGapAndAngleOfAShiftedAndTiltedPlane) {
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const TopoDS_Shape shape = grid(plane, {0, 10, 20, 30}, {0, 10, 20, 30}, {{1, 1}});
  const ShapeIndex index(shape);
  const auto loop = readBoundary(index, holePicks(shape));
  ASSERT_TRUE(loop.has_value());
  constexpr double kLift = 0.03;
  const Handle(Geom_Surface) lifted = new Geom_Plane(gp_Pnt(0, 0, kLift), gp_Dir(0, 0, 1));
  const auto above = measureShape(*loop, grid(lifted, {10, 20}, {10, 20}, {}), {});
  ASSERT_TRUE(above.has_value());
  EXPECT_NEAR(above->largestGap, kLift, 1e-12);
  EXPECT_NEAR(above->largestAngle, 0.0, 1e-9);
  EXPECT_FALSE(above->withinTolerance);

  const double tilt = 0.01;
  const Handle(Geom_Surface) tilted =
      new Geom_Plane(gp_Ax3(gp_Pnt(15, 15, 0), gp_Dir(std::sin(tilt), 0, std::cos(tilt))));
  const auto leaning = measureShape(*loop, grid(tilted, {-8, 8}, {-8, 8}, {}), {});
  ASSERT_TRUE(leaning.has_value());
  EXPECT_NEAR(leaning->largestAngle, tilt * 180.0 / std::numbers::pi, 1e-9);

  // A face that stops 1 mm short of the border: the distance to its trim counts, not that to its
  // plane.
  const auto smaller = measureShape(*loop, grid(plane, {11, 19}, {11, 19}, {}), {});
  ASSERT_TRUE(smaller.has_value());
  EXPECT_GE(smaller->largestGap, 1.0 - 1e-9);
  EXPECT_LE(smaller->largestGap, std::sqrt(2.0) + 1e-9);
}

TEST(MeasureShape, TellsAFaceThatFoldsBackOntoItsNeighbour) {
  // The border of a sheet leaves the hole outside: the sheet itself meets it in a cusp all round,
  // whichever way it is oriented.
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const TopoDS_Shape sheet = grid(plane, {0, 10}, {0, 10}, {});
  const ShapeIndex index(sheet);
  const auto loop = readBoundary(index, {.edges = {1}});
  ASSERT_TRUE(loop.has_value());
  for (const TopoDS_Shape& faces : {sheet, TopoDS_Shape(sheet.Reversed())}) {
    const auto report = measureShape(*loop, faces, {});
    ASSERT_TRUE(report.has_value());
    EXPECT_FALSE(report->withinTolerance);
    for (const auto& side : report->sides) EXPECT_TRUE(side.backwards);
  }
}

TEST(MeasureShape, RefusesAShapeWithoutFaces) {
  const TopoDS_Shape shape = sheetWithHole();
  const auto loop = readBoundary(ShapeIndex(shape), holePicks(shape));
  ASSERT_TRUE(loop.has_value());
  const auto report = measureShape(*loop, compound({}), {});
  ASSERT_FALSE(report.has_value());
  EXPECT_EQ(report.error().code, ErrorCode::ShapeEmpty);
}

}  // namespace
}  // namespace fairing::occt
