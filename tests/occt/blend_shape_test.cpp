// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/blend_shape.h"

#include <gmock/gmock.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>

#include "core/blend/arms.h"
#include "occt/blends.h"
#include "occt/from_occt.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;

constexpr double kRound = 2.0 * std::numbers::pi;

/// Pipes of radius 5 and 9 with one axis, 16 mm apart.
TopoDS_Shape coaxialPipes() {
  return compound({pipe(upright(), 5.0, -14.0, -8.0), pipe(upright(), 9.0, 8.0, 14.0)});
}
BlendPicks coaxialPicks(Continuity continuity = Continuity::G1) {
  return between(coaxialPipes(), {-5, 0, -8}, {-9, 0, 8}, continuity);
}

double largestDistance(const ShapeFill& blend, const Handle(Geom_Surface) & surface) {
  double largest = 0.0;
  for (const Vector3d& p : pointsOf(blend, 16)) {
    const GeomAPI_ProjectPointOnSurf foot(gp_Pnt(p.x(), p.y(), p.z()), surface);
    largest = std::max(largest, foot.LowerDistance());
  }
  return largest;
}

/// Largest distance of the points of one blend from the surface of another.
double apart(const ShapeFill& a, const ShapeFill& b) {
  const TopExp_Explorer face(b.shape, TopAbs_FACE);
  return largestDistance(a, BRep_Tool::Surface(TopoDS::Face(face.Current())));
}

TEST(BlendShape, JoinsTwoPipesByOneValidFaceThatClosesUponItself) {
  const ShapeFill blend = blended(coaxialPipes(), coaxialPicks());
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
  ASSERT_EQ(blend.fill.patches.size(), 1U);
  const auto& patch = blend.fill.patches.front();
  for (int j = 0; j <= 10; ++j) {
    const double v = patch.v.last() * j / 10;
    const auto start = patch.jet(0.0, v), end = patch.jet(patch.u.last(), v);
    EXPECT_LT((start.point - end.point).norm(), 1e-9);
    EXPECT_LT((start.u - end.u).norm(), 1e-6 * start.u.norm());
    EXPECT_LT((start.uu - end.uu).norm(), 1e-4 * start.uu.norm());
  }
}

TEST(BlendShape, OfCoaxialPipesIsASurfaceOfRevolution) {
  const ShapeFill blend = blended(coaxialPipes(), coaxialPicks());
  const auto& patch = blend.fill.patches.front();
  const double limit = 1e-5 * blend.fill.report.diagonal;
  for (int j = 0; j <= 10; ++j) {
    const Vector3d first = patch.evaluate(0.0, patch.v.last() * j / 10);
    for (int i = 1; i < 40; ++i) {
      const Vector3d p = patch.evaluate(patch.u.last() * i / 40, patch.v.last() * j / 10);
      EXPECT_NEAR(p.head<2>().norm(), first.head<2>().norm(), limit);
      EXPECT_NEAR(p.z(), first.z(), limit);
    }
  }
}

// The gradient of the mean curvature, which is made small, vanishes on cylinders and spheres, not
// on a torus.
TEST(BlendShape, OfTwoEndsOfOneSurfaceIsThatSurface) {
  const struct {
    const char* name;
    Handle(Geom_Surface) surface;
    double v0, v1, v2, v3, share;
  } kCases[] = {
      {"cylinder", new Geom_CylindricalSurface(upright(), 5.0), -9, -3, 4, 9, 1e-6},
      {"sphere", new Geom_SphericalSurface(upright(), 10.0), -0.9, -0.3, 0.4, 0.9, 1e-4},
      {"torus", new Geom_ToroidalSurface(upright(), 20.0, 6.0), 0.2, 0.8, 1.8, 2.4, 5e-4},
  };
  for (const auto& c : kCases) {
    const TopoDS_Shape shape =
        grid(c.surface, {0.0, kRound}, {c.v0, c.v1, c.v2, c.v3}, {{0, 1}}, Joint::Loose);
    const double half = 0.5 * kRound;
    const ShapeFill blend = blended(
        shape,
        between(
            shape, fromOcct(c.surface->Value(half, c.v1)), fromOcct(c.surface->Value(half, c.v2))));
    EXPECT_TRUE(blend.fill.report.withinTolerance) << c.name;
    EXPECT_LT(largestDistance(blend, c.surface), c.share * blend.fill.report.diagonal) << c.name;
  }
}

TEST(BlendShape, MeetsCurvatureWhereAsked) {
  const ShapeFill blend = blended(coaxialPipes(), coaxialPicks(Continuity::G2));
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  EXPECT_LT(blend.fill.report.largestCurvature, 0.01);
}

TEST(BlendShape, DoesNotDependOnWhichSideIsFirst) {
  const BlendPicks picks = coaxialPicks();
  const ShapeFill one = blended(coaxialPipes(), picks);
  const ShapeFill other =
      blended(coaxialPipes(), {.from = picks.to, .to = picks.from, .continuity = Continuity::G1});
  EXPECT_LT(apart(one, other), 1e-6 * one.fill.report.diagonal);
}

TEST(BlendShape, DoesNotDependOnTheFacesOrientation) {
  const TopoDS_Shape turned = everySecondReversed(coaxialPipes());
  const ShapeFill one = blended(coaxialPipes(), coaxialPicks());
  const ShapeFill other = blended(turned, between(turned, {-5, 0, -8}, {-9, 0, 8}));
  EXPECT_TRUE(other.fill.report.withinTolerance);
  EXPECT_LT(apart(one, other), 1e-6 * one.fill.report.diagonal);
}

TopoDS_Shape twoPlanes() {
  const Handle(Geom_Surface) floor = new Geom_Plane(upright());
  const Handle(Geom_Surface) wall =
      new Geom_Plane(gp_Ax3(gp_Pnt(12, 0, 9), gp_Dir(-1, 0, 0), gp_Dir(0, -1, 0)));
  return compound({grid(floor, {-10.0, 0.0}, {0.0, 20.0}, {}, Joint::Loose),
                   grid(wall, {-20.0, 0.0}, {0.0, 10.0}, {}, Joint::Loose)});
}

TEST(BlendShape, BetweenTwoPlanesIsACylinder) {
  const TopoDS_Shape shape = twoPlanes();
  const ShapeIndex index(shape);
  for (const Continuity asked : {Continuity::G1, Continuity::G2}) {
    const auto edges = edgesNear(index, {{0, 10, 0}, {12, 10, 9}});
    const ShapeFill blend =
        blended(shape, {.from = {edges[0]}, .to = {edges[1]}, .continuity = asked});
    EXPECT_TRUE(blend.fill.report.withinTolerance);
    EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
    // Every section across the y-axis is the same curve.
    const auto& patch = blend.fill.patches.front();
    for (int j = 0; j <= 10; ++j) {
      const Vector3d first = patch.evaluate(0.0, patch.v.last() * j / 10);
      const Vector3d last = patch.evaluate(patch.u.last(), patch.v.last() * j / 10);
      EXPECT_NEAR(first.x(), last.x(), 1e-4);
      EXPECT_NEAR(first.z(), last.z(), 1e-4);
    }
  }
}

TEST(BlendShape, IsSewnIntoTheBase) {
  const ShapeFill pipes = blended(coaxialPipes(), coaxialPicks(), ResultMode::Base);
  EXPECT_TRUE(BRepCheck_Analyzer(pipes.shape).IsValid());
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(pipes.shape, TopAbs_FACE, faces);
  EXPECT_EQ(faces.Extent(), 3);
  const TopoDS_Shape planes = twoPlanes();
  const auto edges = edgesNear(ShapeIndex(planes), {{0, 10, 0}, {12, 10, 9}});
  const ShapeFill strip = blended(planes, {.from = {edges[0]}, .to = {edges[1]}}, ResultMode::Base);
  EXPECT_TRUE(BRepCheck_Analyzer(strip.shape).IsValid());
}

TEST(BlendShape, TakesChainsOfSmoothEdgesAndAnyStart) {
  const Handle(Geom_Surface) small = new Geom_CylindricalSurface(upright(), 5.0);
  const TopoDS_Shape halves = grid(small, {0.7, 0.7 + 0.4 * kRound, 0.7 + kRound}, {-14, -8}, {});
  const TopoDS_Shape shape = compound({halves, pipe(upright(), 9.0, 8.0, 14.0)});
  const ShapeFill blend = blended(
      shape, between(shape, {5.0 * std::cos(1.957), 5.0 * std::sin(1.957), -8}, {-9, 0, 8}));
  EXPECT_EQ(blend.fill.report.sides.size(), 3U);
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  const ShapeFill whole = blended(coaxialPipes(), coaxialPicks());
  EXPECT_LT(apart(blend, whole), 1e-5 * whole.fill.report.diagonal);
}

// Where the strip starts and where two edges of a rim meet are one place but for rounding.
TEST(BlendShape, StartsWhereEdgesOfARimMeet) {
  const Handle(Geom_Surface) wide = new Geom_CylindricalSurface(upright(), 10.0);
  const TopoDS_Shape shape =
      compound({grid(wide, {0.0, 0.5 * kRound, kRound}, {0.0, 20.0}, {}, Joint::Loose),
                pipe(upright(), 6.0, 35.0, 50.0)});
  const auto edges = edgesNear(ShapeIndex(shape), {{0, 10, 20}, {0, -10, 20}, {-6, 0, 35}});
  for (const auto& [from, to] : {std::pair{std::vector{edges[2]}, std::vector{edges[0], edges[1]}},
                                 {{edges[0], edges[1]}, {edges[2]}}}) {
    const ShapeFill blend = blended(shape, {.from = from, .to = to});
    EXPECT_TRUE(blend.fill.report.withinTolerance);
  }
}

// A rim of two halves, each met in its own way.
TEST(BlendShape, MeetsEveryEdgeOfARimAsAsked) {
  const Handle(Geom_Surface) wide = new Geom_CylindricalSurface(upright(), 10.0);
  const TopoDS_Shape shape =
      compound({grid(wide, {0.0, 0.5 * kRound, kRound}, {0.0, 20.0}, {}, Joint::Loose),
                pipe(upright(), 6.0, 35.0, 50.0)});
  const auto edges = edgesNear(ShapeIndex(shape), {{0, 10, 20}, {0, -10, 20}, {-6, 0, 35}});
  for (const auto& [one, other] : {std::pair{Continuity::G0, Continuity::G1},
                                   {Continuity::G0, Continuity::G2},
                                   {Continuity::G1, Continuity::G2}}) {
    const ShapeFill blend = blended(shape,
                                    {.from = {edges[0], edges[1]},
                                     .to = {edges[2]},
                                     .edgeContinuity = {{edges[0], one}, {edges[1], other}}});
    SCOPED_TRACE(::testing::Message() << int(one) << int(other));
    expectWithin(blend);
  }
}

TEST(BlendShape, ReachesAsFarAsAskedAndStaysTangent) {
  const TopoDS_Shape shape = coaxialPipes();
  const ShapeIndex index(shape);
  const ShapeFill natural = blended(shape, coaxialPicks());
  const auto departure = [](const ShapeFill& blend, bool first) {
    const auto& patch = blend.fill.patches.front();
    return patch.jet(0.0, first ? 0.0 : patch.v.last()).v.norm();
  };
  for (const Continuity asked : {Continuity::G1, Continuity::G2}) {
    const ShapeFill one = blended(shape, coaxialPicks(asked));
    const auto longer =
        blendShape(index, coaxialPicks(asked), {{}, {1.5, 0.7}}, ResultMode::Patches);
    ASSERT_TRUE(longer.has_value());
    EXPECT_LT(longer->fill.report.largestAngle, 0.02);
    EXPECT_NEAR(departure(*longer, true), 1.5 * departure(one, true), 1e-9);
    EXPECT_NEAR(departure(*longer, false), 0.7 * departure(one, false), 1e-9);
  }
  const auto same = blendShape(index, coaxialPicks(), {{}, {1.0 + 1e-9, 1.0}}, ResultMode::Patches);
  EXPECT_LT(apart(*same, natural), 1e-6 * natural.fill.report.diagonal);
  const auto none = blendShape(index, coaxialPicks(), {{}, {0.0, 1.0}}, ResultMode::Patches);
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, ErrorCode::ReachNotPositive);
}

TEST(BlendShape, AKeptBlendReachesAsOneThatIsMadeAnew) {
  const TopoDS_Shape shape = coaxialPipes();
  const auto natural = blendShape(ShapeIndex(shape), coaxialPicks(), {}, ResultMode::Base);
  ASSERT_TRUE(natural.has_value());
  const auto anew =
      blendShape(ShapeIndex(shape), coaxialPicks(), {{}, {1.5, 0.7}}, ResultMode::Patches);
  ASSERT_TRUE(anew.has_value());
  const auto moved = reaching(*natural, {1.5, 0.7});
  ASSERT_TRUE(moved.has_value());
  EXPECT_TRUE(moved->fill.report.withinTolerance);
  // the same solve of the same system, to the last bit
  EXPECT_EQ(moved->fill.patches.front().poles, anew->fill.patches.front().poles);
  const auto back = reaching(*moved, {1.0, 1.0});
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->fill.patches.front().poles, natural->fill.patches.front().poles);
  const auto none = reaching(*natural, {1.0, -1.0});
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, ErrorCode::ReachNotPositive);
}

TEST(BlendShape, HasArmsAlongTheFacesItLeaves) {
  const ShapeFill blend = blended(coaxialPipes(), coaxialPicks());
  const auto arms = armsOf(blend.fill.patches);
  const std::array<double, 2> radii{5.0, 9.0}, heights{-8.0, 8.0};
  for (const std::size_t k : {0U, 1U}) {
    const Vector3d& point = arms[k].point;
    const double gap = 1e-6 * blend.fill.report.diagonal;  // sides are met as closely as that
    EXPECT_NEAR(point.head<2>().norm(), radii[k], gap);
    EXPECT_NEAR(point.z(), heights[k], gap);
    const Vector3d up = arms[k].vector.normalized() * (k == 0 ? 1.0 : -1.0);
    EXPECT_LT((up - Vector3d::UnitZ()).norm(), 1e-4);  // 0.02 degrees are 3.5e-4
  }
}

/// A pipe of radius 5, and one of radius 9 beside its axis and tilted against it by 20 degrees.
TopoDS_Shape tiltedPipes(double start) {
  const double tilt = 20.0 * std::numbers::pi / 180.0;
  const gp_Dir axis(std::sin(tilt), 0, std::cos(tilt));
  const gp_Ax3 frame(gp_Pnt(4, 2, 8), axis, gp_Dir(std::cos(tilt), 0, -std::sin(tilt)));
  const Handle(Geom_Surface) wide = new Geom_CylindricalSurface(frame, 9.0);
  const Handle(Geom_Surface) narrow = new Geom_CylindricalSurface(upright(), 5.0);
  return compound({grid(narrow, {start, start + kRound}, {-14, -8}, {}, Joint::Loose),
                   grid(wide, {2.0 * start, 2.0 * start + kRound}, {0, 6}, {}, Joint::Loose)});
}

/// The rims that face each other, by their middles.
BlendPicks tiltedPicks(const TopoDS_Shape& shape, double start) {
  const double tilt = 20.0 * std::numbers::pi / 180.0, half = 0.5 * kRound;
  const double a = start + half, b = 2.0 * start + half;
  const Vector3d across(std::cos(tilt), 0, -std::sin(tilt));
  return between(
      shape,
      {5.0 * std::cos(a), 5.0 * std::sin(a), -8},
      Vector3d(4, 2, 8) + 9.0 * (std::cos(b) * across + std::sin(b) * Vector3d::UnitY()));
}

TEST(BlendShape, DoesNotDependOnWhereClosedSidesStart) {
  const TopoDS_Shape plain = tiltedPipes(0.0), moved = tiltedPipes(0.9);
  const BlendPicks picks = tiltedPicks(plain, 0.0);
  const ShapeFill one = blended(plain, picks);
  EXPECT_TRUE(one.fill.report.withinTolerance);
  const double limit = 1e-6 * one.fill.report.diagonal;
  EXPECT_LT(apart(one, blended(moved, tiltedPicks(moved, 0.9))), limit);
  EXPECT_LT(apart(one, blended(plain, {.from = picks.to, .to = picks.from})), limit);
}

TEST(BlendShape, ReachesWhereNothingIsSymmetric) {
  const TopoDS_Shape shape = tiltedPipes(0.3);
  const auto blend =
      blendShape(ShapeIndex(shape), tiltedPicks(shape, 0.3), {{}, {1.3, 1.0}}, ResultMode::Patches);
  ASSERT_TRUE(blend.has_value());
  EXPECT_TRUE(blend->fill.report.withinTolerance);
}

TEST(BlendShape, RefusesWhatItCannotJoin) {
  const TopoDS_Shape pipes = coaxialPipes(), planes = twoPlanes();
  const BlendPicks good = coaxialPicks();
  EXPECT_EQ(refusal(pipes, {}), ErrorCode::NothingPicked);
  EXPECT_EQ(refusal(pipes, {.from = good.from}), ErrorCode::OneSideOnly);
  EXPECT_EQ(refusal(pipes, {.from = good.from, .to = good.from}), ErrorCode::EdgeOnBothSides);
  EXPECT_EQ(refusal(pipes, {.from = good.from, .to = {99}}), ErrorCode::EdgeOutOfRange);
  const TopoDS_Shape mixed = compound({pipes, planes});
  EXPECT_EQ(refusal(mixed, between(mixed, {-5, 0, -8}, {12, 10, 9})), ErrorCode::ChainsUnlike);
  const auto opposite = edgesNear(ShapeIndex(planes), {{0, 10, 0}, {-10, 10, 0}, {12, 10, 9}});
  EXPECT_EQ(refusal(planes, {.from = {opposite[0], opposite[1]}, .to = {opposite[2]}}),
            ErrorCode::ChainBroken);
}

}  // namespace
}  // namespace fairing::occt
