// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <cmath>
#include <functional>
#include <numbers>

#include "occt/blends.h"
#include "occt/fill_shape.h"
#include "occt/from_occt.h"
#include "occt/shapes.h"
#include "text/error_text.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;

/// A lone edge along a Bezier curve.
TopoDS_Shape bezier(const std::vector<Vector3d>& poles) {
  TColgp_Array1OfPnt points(1, int(poles.size()));
  for (std::size_t k = 0; k < poles.size(); ++k) points(int(k) + 1) = toPoint(poles[k]);
  return BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(points)).Edge();
}

/// An S from a plane at z = 0 to one at z = 6, in the plane x = const.
TopoDS_Shape sCurve(double x) {
  return bezier({{x, 0, 0}, {x, 4, 0}, {x, 6, 6}, {x, 10, 6}});
}

/// Two plates of width 20 at heights 0 and 6, and beside them an S at either end.
TopoDS_Shape plates() {
  return compound({polygon({{0, 0, 0}, {20, 0, 0}, {20, -9, 0}, {0, -9, 0}}),
                   polygon({{0, 10, 6}, {20, 10, 6}, {20, 19, 6}, {0, 19, 6}}),
                   sCurve(0.0),
                   sCurve(20.0)});
}

BlendPicks platePicks(const std::vector<Vector3d>& ends = {{0, 5, 3}, {20, 5, 3}}) {
  return picksNear(plates(), {{10, 0, 0}}, {{10, 10, 6}}, ends);
}

void expectTangent(const ShapeFill& blend) {
  const auto& report = blend.fill.report;
  EXPECT_TRUE(report.withinTolerance) << report.largestAngle << ' ' << report.largestCornerAngle
                                      << ' ' << report.largestGap << ' ' << report.largestCurvature;
  EXPECT_LT(report.largestAngle, 0.02);
  EXPECT_LT(report.largestCornerAngle, 0.05);
  EXPECT_LT(report.largestGap, 1e-6 * report.diagonal);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
}

/// Largest distance of the blend's points from a surface given by its distance.
double farthest(const ShapeFill& blend, const std::function<double(const Vector3d&)>& distance) {
  double largest = 0.0;
  for (const Vector3d& p : pointsOf(blend, 24)) largest = std::max(largest, std::abs(distance(p)));
  return largest;
}

TEST(BlendEnds, MeetCurvesDrawnAtBothEnds) {
  const ShapeFill blend = blended(plates(), platePicks());
  expectTangent(blend);
  ASSERT_EQ(blend.fill.report.sides.size(), 4U);
  // All is symmetric about the plane x = 10.
  const auto& patch = blend.fill.patches.front();
  for (int j = 0; j <= 10; ++j)
    for (int i = 0; i <= 5; ++i) {
      const double v = patch.v.last() * j / 10;
      const Vector3d p = patch.evaluate(patch.u.last() * i / 10, v);
      const Vector3d q = patch.evaluate(patch.u.last() * (10 - i) / 10, v);
      EXPECT_LT((p - Vector3d(20 - q.x(), q.y(), q.z())).norm(), 1e-6 * blend.fill.report.diagonal);
    }
}

/// The hole in the sheet as a strip: two of its sides opposite each other, and the other two as
/// ends.
BlendPicks sheetPicks(const TopoDS_Shape& sheet) {
  const std::vector<int> around = innerFreeEdges(ShapeIndex(sheet));
  return {.from = {around[0]}, .to = {around[2]}, .ends = {around[3], around[1]}};
}

TEST(BlendEnds, OfFourSidesAreAsGoodAsFillHole) {
  const TopoDS_Shape sheet = sheetWithHole();
  const ShapeFill strip = blended(sheet, sheetPicks(sheet), ResultMode::Base);
  expectTangent(strip);
  const auto hole = fillShape(
      ShapeIndex(sheet), {.edges = innerFreeEdges(ShapeIndex(sheet))}, {}, ResultMode::Patches);
  ASSERT_TRUE(hole);
  EXPECT_LT(strip.fill.report.largestAngle, std::max(0.01, 1.5 * hole->fill.report.largestAngle));
  double apart = 0.0;
  const auto whole = pointsOf(*hole, 12);
  for (const Vector3d& p : pointsOf(strip, 12)) {
    double nearest = 1e9;
    for (const Vector3d& q : whole) nearest = std::min(nearest, (p - q).norm());
    apart = std::max(apart, nearest);
  }
  EXPECT_LT(apart, 0.05 * strip.fill.report.diagonal);  // between the points of a grid of 12
}

TEST(BlendEnds, MeetCurvatureWhereAsked) {
  const TopoDS_Shape sheet = sheetWithHole();
  BlendPicks picks = sheetPicks(sheet);
  picks.continuity = Continuity::G2;
  const ShapeFill strip = blended(sheet, picks);
  expectTangent(strip);
  EXPECT_LT(strip.fill.report.largestCurvature, 0.01);
}

TEST(BlendEnds, AreFoundByTheFacesBesideThem) {
  const TopoDS_Shape sheet = sheetWithHole();
  BlendPicks picks = sheetPicks(sheet);
  const ShapeFill byEdges = blended(sheet, picks);
  const ShapeIndex index(sheet);
  picks.endFaces = {index.uses(picks.ends[0]).front().face, index.uses(picks.ends[1]).front().face};
  picks.ends.clear();
  const ShapeFill byFaces = blended(sheet, picks);
  EXPECT_THAT(edgesOf(byFaces.loop), ::testing::ElementsAreArray(edgesOf(byEdges.loop)));
  EXPECT_NEAR(area(byFaces.shape), area(byEdges.shape), 1e-9 * area(byEdges.shape));
}

/// Faces of a surface round one that is left out.
TopoDS_Shape roundHole(const Handle(Geom_Surface) & surface,
                       const std::vector<double>& u,
                       const std::vector<double>& v) {
  return grid(surface, u, v, {{1, 1}}, Joint::Sewn);
}

TEST(BlendEnds, GiveBackAPieceOfACylinder) {
  const TopoDS_Shape shape =
      roundHole(new Geom_CylindricalSurface(upright(), 10.0), {0, 0.5, 1.3, 1.8}, {0, 5, 15, 20});
  const std::vector<int> around = innerFreeEdges(ShapeIndex(shape));
  for (const std::size_t start : {0, 1}) {
    const ShapeFill strip = blended(shape,
                                    {.from = {around[start]},
                                     .to = {around[start + 2]},
                                     .ends = {around[1 - start], around[3 - start]}});
    expectTangent(strip);
    EXPECT_LT(farthest(strip, [](const Vector3d& p) { return p.head<2>().norm() - 10.0; }),
              1e-4 * strip.fill.report.diagonal);
  }
}

TEST(BlendEnds, GiveBackAPieceOfASphere) {
  const TopoDS_Shape shape = roundHole(
      new Geom_SphericalSurface(upright(), 10.0), {0, 0.5, 1.2, 1.8}, {-0.8, -0.3, 0.3, 0.8});
  const std::vector<int> around = innerFreeEdges(ShapeIndex(shape));
  const ShapeFill strip =
      blended(shape, {.from = {around[0]}, .to = {around[2]}, .ends = {around[1], around[3]}});
  expectTangent(strip);
  EXPECT_LT(farthest(strip, [](const Vector3d& p) { return p.norm() - 10.0; }),
            1e-4 * strip.fill.report.diagonal);
}

TEST(BlendEnds, CloseTheMissingSideOfABox) {
  const TopoDS_Shape whole = box(10, 8, 6);
  std::vector<TopoDS_Shape> faces;
  const ShapeIndex index(whole);
  for (int k = 1; k <= index.faceCount(); ++k) faces.push_back(index.face(k));
  faces.erase(faces.begin());  // x = 0
  const TopoDS_Shape open = compound(faces);
  BlendPicks picks = picksNear(open, {{0, 4, 0}}, {{0, 4, 6}}, {{0, 0, 3}, {0, 8, 3}});
  picks.continuity = Continuity::G0;
  const ShapeFill strip = blended(open, picks, ResultMode::Base);
  EXPECT_TRUE(strip.fill.report.withinTolerance);
  EXPECT_LT(farthest(strip, [](const Vector3d& p) { return p.x(); }), 1e-9);
  EXPECT_NEAR(volume(strip.shape), 480.0, 1e-6);
}

TEST(BlendEnds, MayFollowSomethingAtOneEndOnly) {
  for (const double x : {0.0, 20.0}) {
    const ShapeFill blend = blended(plates(), platePicks({{x, 5, 3}}));
    expectTangent(blend);
    ASSERT_EQ(blend.fill.report.sides.size(), 3U);
    const auto& patch = blend.fill.patches.front();
    const double u = std::abs(patch.evaluate(0, 0).x() - x) < 1e-6 ? 0.0 : patch.u.last();
    for (int j = 0; j <= 10; ++j)
      EXPECT_NEAR(patch.evaluate(u, patch.v.last() * j / 10).x(), x, 1e-6);
  }
}

TEST(BlendEnds, DoNotDependOnTheOrderOfSidesAndPicks) {
  const TopoDS_Shape sheet = sheetWithHole();
  const BlendPicks picks = sheetPicks(sheet);
  const ShapeFill one = blended(sheet, picks);
  const ShapeFill other =
      blended(sheet, {.from = picks.to, .to = picks.from, .ends = {picks.ends[1], picks.ends[0]}});
  const auto& a = one.fill.patches.front();
  const auto& b = other.fill.patches.front();
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 8; ++j) {
      const Vector3d p = a.evaluate(a.u.last() * i / 8, a.v.last() * j / 8);
      const Vector3d q = b.evaluate(b.u.last() * (8 - i) / 8, b.v.last() * (8 - j) / 8);
      EXPECT_LT((p - q).norm(), 1e-6 * one.fill.report.diagonal);
    }
  const TopoDS_Shape turned = everySecondReversed(sheet);
  const ShapeFill third = blended(turned, sheetPicks(turned));
  EXPECT_NEAR(area(one.shape), area(third.shape), 1e-6 * area(one.shape));
}

/// An L of two plane faces in one plane z = const, its inner rim at x = s and y = s.
TopoDS_Shape plateL(double near, double far, double z) {
  return compound({polygon({{near, near, z}, {30, near, z}, {30, far, z}, {far, far, z}}),
                   polygon({{near, near, z}, {far, far, z}, {far, 30, z}, {near, 30, z}})});
}

TEST(BlendEnds, OfARowOfPatchesBelongToItsFirstAndItsLast) {
  const TopoDS_Shape shape = compound({plateL(0, -5, 0),
                                       plateL(4, 10, 6),
                                       bezier({{30, 0, 0}, {30, 2, 0}, {30, 2, 6}, {30, 4, 6}}),
                                       bezier({{0, 30, 0}, {2, 30, 0}, {2, 30, 6}, {4, 30, 6}})});
  const ShapeFill blend = blended(
      shape,
      picksNear(
          shape, {{15, 0, 0}, {0, 15, 0}}, {{17, 4, 6}, {4, 17, 6}}, {{30, 2, 3}, {2, 30, 3}}),
      ResultMode::Shell);
  expectTangent(blend);
  ASSERT_EQ(blend.fill.patches.size(), 2U);
  ASSERT_EQ(blend.fill.report.sides.size(), 6U);
  ASSERT_EQ(blend.fill.report.seams.size(), 1U);
  EXPECT_LT(blend.fill.report.seams[0].angle.max, 0.02);
}

TEST(BlendEnds, MayHaveSeveralEdgesThatContinueEachOther) {
  const TopoDS_Shape shape = compound({polygon({{0, 0, 0}, {20, 0, 0}, {20, -9, 0}, {0, -9, 0}}),
                                       polygon({{0, 10, 6}, {20, 10, 6}, {20, 19, 6}, {0, 19, 6}}),
                                       bezier({{0, 0, 0}, {0, 2, 0}, {0, 3.5, 1.5}, {0, 5, 3}}),
                                       bezier({{0, 10, 6}, {0, 8, 6}, {0, 6.5, 4.5}, {0, 5, 3}})});
  const ShapeFill blend =
      blended(shape, picksNear(shape, {{10, 0, 0}}, {{10, 10, 6}}, {{0, 2.7, 1}, {0, 7.3, 5}}));
  expectTangent(blend);
  EXPECT_EQ(blend.fill.report.sides.size(), 4U);
}

// --- Walls.

/// Two plates between x = 0 and 20 whose left sides stand on a wall.
TopoDS_Shape platesOn(const TopoDS_Shape& wall, double lower, double upper) {
  return compound({polygon({{lower, 0, 0}, {20, 0, 0}, {20, -9, 0}, {lower, -9, 0}}),
                   polygon({{upper, 10, 6}, {20, 10, 6}, {20, 19, 6}, {upper, 19, 6}}),
                   wall});
}

BlendPicks wallPicks(const TopoDS_Shape& shape) {
  BlendPicks picks = picksNear(shape, {{10, 0, 0}}, {{10, 10, 6}}, {});
  picks.endFaces = {ShapeIndex(shape).faceCount()};
  return picks;
}

/// Largest distance from a surface of the end that lies nearer to it.
double endOff(const ShapeFill& blend, const std::function<double(const Vector3d&)>& distance) {
  double nearest = 1e9;
  const auto& patch = blend.fill.patches.front();
  for (const double u : {0.0, patch.u.last()}) {
    double largest = 0.0;
    for (int j = 0; j <= 200; ++j)
      largest = std::max(largest, std::abs(distance(patch.evaluate(u, patch.v.last() * j / 200))));
    nearest = std::min(nearest, largest);
  }
  return nearest;
}

TEST(BlendEnds, SlideOnAPlane) {
  // z = 3 x, so that the ends lie at x = 0 and x = 2.
  const TopoDS_Shape shape =
      platesOn(polygon({{-5, -20, -15}, {-5, 30, -15}, {5, 30, 15}, {5, -20, 15}}), 0.0, 2.0);
  for (const Continuity continuity : {Continuity::G1, Continuity::G2}) {
    BlendPicks picks = wallPicks(shape);
    picks.continuity = continuity;
    const ShapeFill blend = blended(shape, picks, ResultMode::Base);
    expectTangent(blend);
    ASSERT_EQ(blend.fill.report.sides.size(), 3U);
    EXPECT_LT(
        endOff(blend, [](const Vector3d& p) { return (p.z() - 3 * p.x()) / std::sqrt(10.0); }),
        1e-6);
  }
}

TEST(BlendEnds, SlideOnACylinder) {
  // About the line x = -8, z = 3 along y, of radius 10.
  const double x = -8.0 + std::sqrt(100.0 - 9.0);
  const gp_Ax3 frame(gp_Pnt(-8, 0, 3), gp_Dir(0, 1, 0), gp_Dir(1, 0, 0));
  const TopoDS_Shape wall =
      grid(new Geom_CylindricalSurface(frame, 10.0), {-1.0, 1.0}, {-20, 30}, {}, Joint::Loose);
  const ShapeFill blend = blended(platesOn(wall, x, x), wallPicks(platesOn(wall, x, x)));
  expectTangent(blend);
  EXPECT_LT(
      endOff(blend, [](const Vector3d& p) { return std::hypot(p.x() + 8, p.z() - 3) - 10.0; }),
      1e-6);
}

// --- Reach, direction, setback.

BlendOptions reaching(double first, double second) {
  BlendOptions options;
  options.reach = {{first, second}};
  return options;
}

TEST(BlendEnds, StayTangentWhateverTheReach) {
  const TopoDS_Shape sheet = sheetWithHole();
  for (const double reach : {0.7, 1.4}) {
    expectTangent(blended(plates(), platePicks(), ResultMode::Patches, reaching(reach, reach)));
    expectTangent(
        blended(plates(), platePicks({{0, 5, 3}}), ResultMode::Patches, reaching(reach, 1)));
    expectTangent(blended(sheet, sheetPicks(sheet), ResultMode::Patches, reaching(reach, 1.0)));
    expectTangent(blended(sheet, sheetPicks(sheet), ResultMode::Patches, reaching(reach, reach)));
  }
}

TEST(BlendEnds, StayTangentBesideCurvedFacesWhateverTheReach) {
  const TopoDS_Shape cylinder =
      roundHole(new Geom_CylindricalSurface(upright(), 10.0), {0, 0.5, 1.3, 1.8}, {0, 5, 15, 20});
  const TopoDS_Shape sphere = roundHole(
      new Geom_SphericalSurface(upright(), 10.0), {0, 0.5, 1.2, 1.8}, {-0.8, -0.3, 0.3, 0.8});
  for (const TopoDS_Shape& shape : {cylinder, sphere}) {
    const std::vector<int> around = innerFreeEdges(ShapeIndex(shape));
    for (const double reach : {0.7, 1.4})
      for (const Continuity continuity : {Continuity::G1, Continuity::G2}) {
        const ShapeFill strip = blended(shape,
                                        {.from = {around[0]},
                                         .to = {around[2]},
                                         .continuity = continuity,
                                         .ends = {around[1], around[3]}},
                                        ResultMode::Patches,
                                        reaching(reach, reach));
        expectTangent(strip);
        EXPECT_LT(strip.fill.report.largestAngle, 1e-3);
      }
  }
}

TEST(BlendEnds, ActWithReachInTheMiddle) {
  const auto leg = [](const ShapeFill& blend) {
    const auto& patch = blend.fill.patches.front();
    return patch.jet(0.5 * patch.u.last(), 0.0).v.norm();
  };
  const double natural = leg(blended(plates(), platePicks()));
  const double longer =
      leg(blended(plates(), platePicks(), ResultMode::Patches, reaching(1.4, 1.4)));
  EXPECT_NEAR(longer / natural, 1.4, 0.01);  // a spline through the fading factor
}

TEST(BlendEnds, LeaveSidesAsAskedOrSaySo) {
  BlendOptions perpendicular;
  perpendicular.departure = {boundary::Departure::Perpendicular,
                             boundary::Departure::Perpendicular};
  expectTangent(blended(plates(), platePicks(), ResultMode::Patches, perpendicular));
  BlendOptions flipped;
  flipped.leaving[0] = boundary::Leaving::Backwards;
  EXPECT_EQ(refusal(plates(), platePicks(), flipped), ErrorCode::EndAgainstSide);
  const TopoDS_Shape oblique =
      platesOn(polygon({{-5, -20, -15}, {-5, 30, -15}, {5, 30, 15}, {5, -20, 15}}), 0.0, 2.0);
  EXPECT_TRUE(tryBlend(oblique, wallPicks(oblique), ResultMode::Patches, flipped).has_value());
}

TEST(BlendEnds, SlideWhereASetbackBegins) {
  const TopoDS_Shape shape =
      platesOn(polygon({{0, -20, -15}, {0, 30, -15}, {0, 30, 15}, {0, -20, 15}}), 0.0, 0.0);
  BlendPicks picks = wallPicks(shape);
  picks.setback = {3.0, 2.0};
  const ShapeFill blend = blended(shape, picks);
  expectTangent(blend);
  EXPECT_LT(endOff(blend, [](const Vector3d& p) { return p.x(); }), 1e-6);
  EXPECT_NEAR(blend.fill.patches.front().evaluate(0.0, 0.0).y(), -3.0, 1e-6);
}

// --- Refusals.

TEST(BlendEnds, ThatJoinNothingAreRefusedWithTheirDistance) {
  const TopoDS_Shape shape =
      compound({plates(), bezier({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 4}})});
  const Error error =
      errorOf(shape, picksNear(shape, {{10, 0, 0}}, {{10, 10, 6}}, {{0, 1.5, 0.5}}));
  EXPECT_EQ(error.code, ErrorCode::EndJoinsNothing);
  ASSERT_TRUE(error.where);
  EXPECT_LT((*error.where - Vector3d(0, 3, 4)).norm(), 1e-9);
  EXPECT_NEAR(error.value, 5.0, 1e-9);
}

TEST(BlendEnds, ThatAreSidesOrComeTwiceAreRefused) {
  BlendPicks picks = platePicks();
  picks.ends.push_back(picks.from.front());
  EXPECT_EQ(refusal(plates(), picks), ErrorCode::EndOnSide);
  const TopoDS_Shape twice =
      compound({plates(), bezier({{0, 0, 0}, {-1, 4, 0}, {-1, 6, 6}, {0, 10, 6}})});
  EXPECT_EQ(
      refusal(twice, picksNear(twice, {{10, 0, 0}}, {{10, 10, 6}}, {{0, 5, 3}, {-0.75, 5, 3}})),
      ErrorCode::EndTwice);
}

TEST(BlendEnds, WithACornerInsideAreRefused) {
  const TopoDS_Shape shape = compound({plates(),
                                       bezier({{0, 0, 0}, {0, 2, 0}, {0, 5, 0}}),
                                       bezier({{0, 5, 0}, {0, 5, 3}, {0, 10, 6}})});
  const Error error =
      errorOf(shape, picksNear(shape, {{10, 0, 0}}, {{10, 10, 6}}, {{0, 2.25, 0}, {0, 6.25, 3}}));
  EXPECT_EQ(error.code, ErrorCode::EndTurns);
  EXPECT_NEAR(error.value, 90.0, 1e-6);
}

TEST(BlendEnds, ThatGoOnAlongASideAreRefused) {
  const TopoDS_Shape shape =
      compound({plates(), bezier({{0, 0, 0}, {-6, 0.5, 0}, {-6, 9, 6}, {0, 10, 6}})});
  const Error error =
      errorOf(shape, picksNear(shape, {{10, 0, 0}}, {{10, 10, 6}}, {{-4.5, 4.8, 3}}));
  EXPECT_EQ(error.code, ErrorCode::EndAlongSide);
  EXPECT_NEAR(error.value, 180.0 - std::atan(0.5 / 6.0) * 180.0 / std::numbers::pi, 1e-6);
}

TEST(BlendEnds, OfClosedSidesAreRefused) {
  const TopoDS_Shape pipes =
      compound({pipe(upright(), 5, 0, 5), pipe(upright(), 8, 12, 20), sCurve(30)});
  BlendPicks picks = between(pipes, {-5, 0, 5}, {-8, 0, 12});
  picks.ends = edgesNear(ShapeIndex(pipes), {{30, 5, 3}});
  EXPECT_EQ(refusal(pipes, picks), ErrorCode::EndsUnused);
}

TEST(BlendEnds, FarFromAFaceAreRefusedWithTheDistance) {
  const TopoDS_Shape shape =
      platesOn(polygon({{-4, -20, -15}, {-4, 30, -15}, {-4, 30, 15}, {-4, -20, 15}}), 0.0, 0.0);
  const Error error = errorOf(shape, wallPicks(shape));
  EXPECT_EQ(error.code, ErrorCode::EndOffFace);
  EXPECT_NEAR(error.value, 4.0, 1e-9);
  BlendPicks picks = platePicks();
  picks.endFaces = {99};
  EXPECT_EQ(refusal(plates(), picks), ErrorCode::FaceOutOfRange);
}

TEST(BlendEnds, ThatWouldSlideOffTheirFaceAreRefused) {
  const TopoDS_Shape shape =
      platesOn(polygon({{0, -1, -0.8}, {0, -1, 8}, {0, 11, 8}, {0, 11, 6.4}}), 0.0, 0.0);
  const Error error = errorOf(shape, wallPicks(shape));
  EXPECT_EQ(error.code, ErrorCode::EndLeavesFace);
}

}  // namespace
}  // namespace fairing::occt
