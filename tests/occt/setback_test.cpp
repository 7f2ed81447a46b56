// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/setback.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>

#include "occt/bilinear.h"
#include "occt/blends.h"
#include "occt/edge_curve.h"
#include "occt/shapes.h"
#include "text/error_text.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;

constexpr double kRound = 2.0 * std::numbers::pi;
constexpr int kSamples = 50;

/// A cylinder with one of its two lids, that at height `lid`.
TopoDS_Shape can(double radius, double from, double to, double lid) {
  const TopoDS_Shape solid =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, from), gp_Dir(0, 0, 1)), radius, to - from);
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(it.Current()));
    if (surface.GetType() == GeomAbs_Plane && std::abs(surface.Plane().Location().Z() - lid) > 0.1)
      continue;
    faces.push_back(it.Current());
  }
  return compound(faces);
}
TopoDS_Shape cans() {
  return compound({can(5.0, -14, -8, -14), can(9.0, 8, 14, 14)});
}

BlendPicks between(const TopoDS_Shape& shape,
                   const Vector3d& from,
                   const Vector3d& to,
                   std::array<double, 2> setback) {
  BlendPicks picks = testing::between(shape, from, to);
  picks.setback = setback;
  return picks;
}
BlendPicks cansPicks(std::array<double, 2> setback) {
  return between(cans(), {-5, 0, -8}, {-9, 0, 8}, setback);
}

Vector3d onSide(const ShapeFill& blend, bool first, int k) {
  const auto& patch = blend.fill.patches.front();
  return patch.evaluate(patch.u.last() * k / kSamples, first ? 0.0 : patch.v.last());
}

TEST(Setback, StartsInsideThePipesAtTheDistanceAsked) {
  const ShapeFill blend = blended(cans(), cansPicks({2.0, 3.0}));
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  for (int k = 0; k <= kSamples; ++k) {
    EXPECT_NEAR(onSide(blend, true, k).z(), -10.0, 1e-6);
    EXPECT_NEAR(onSide(blend, true, k).head<2>().norm(), 5.0, 1e-5);
    EXPECT_NEAR(onSide(blend, false, k).z(), 11.0, 1e-6);
  }
}

TEST(Setback, SewsTrimmedFacesToOneSolid) {
  const ShapeFill plain = blended(cans(), cansPicks({0.0, 0.0}), ResultMode::Base);
  const ShapeFill blend = blended(cans(), cansPicks({2.0, 3.0}), ResultMode::Base);
  for (const ShapeFill& result : {plain, blend}) {
    EXPECT_EQ(TopExp_Explorer(result.shape, TopAbs_SOLID).More(), true);
    EXPECT_TRUE(BRepCheck_Analyzer(result.shape).IsValid());
  }
  EXPECT_GT(std::abs(volume(blend.shape) - volume(plain.shape)), 1.0);
}

TEST(Setback, ReportsSpeakOfTheEdgesPicked) {
  const BlendPicks picks = cansPicks({2.0, 0.0});
  const ShapeIndex index(cans());
  const ShapeFill blend = blended(cans(), picks);
  ASSERT_EQ(blend.fill.report.sides.size(), 2U);
  EXPECT_EQ(blend.fill.report.sides[0].edge, picks.from.front());
  EXPECT_EQ(blend.fill.report.sides[1].edge, picks.to.front());
  EXPECT_EQ(blend.fill.report.sides[0].face, index.uses(picks.from.front()).front().face);
  EXPECT_EQ(blend.loop.sides[0].edge, picks.from.front());
}

TEST(Setback, TakesWishesOfTheEdgesPicked) {
  BlendPicks picks = cansPicks({2.0, 2.0});
  picks.edgeContinuity[picks.to.front()] = Continuity::G2;
  const ShapeFill blend = blended(cans(), picks);
  EXPECT_EQ(blend.fill.report.sides[0].asked, Continuity::G1);
  EXPECT_EQ(blend.fill.report.sides[1].asked, Continuity::G2);
  picks.edgeContinuity[99] = Continuity::G0;
  const auto wrong = tryBlend(cans(), picks);
  ASSERT_FALSE(wrong.has_value());
  EXPECT_EQ(wrong.error().code, ErrorCode::EdgeNotInLoop);
}

TEST(Setback, IsTurnedAsTheSidesAreAligned) {
  BlendPicks picks = cansPicks({2.0, 2.0});
  const ShapeFill straight = blended(cans(), picks);
  picks.alignment = 0.2;
  EXPECT_GT(
      (blended(cans(), picks).fill.patches.front().poles - straight.fill.patches.front().poles)
          .rowwise()
          .norm()
          .maxCoeff(),
      1.0);
  picks.alignment = 0.7;
  EXPECT_EQ(refusal(cans(), picks), ErrorCode::AlignmentOutOfRange);
}

/// A floor that widens away from its edge x = 0, where it runs from y = 0 to y = 20, and a wall.
TopoDS_Shape planes(double widening) {
  const Handle(Geom_Surface) floor =
      bilinear({-10, -widening, 0}, {-10, 20 + widening, 0}, {0, 0, 0}, {0, 20, 0});
  const Handle(Geom_Surface) wall =
      new Geom_Plane(gp_Ax3(gp_Pnt(12, 0, 9), gp_Dir(-1, 0, 0), gp_Dir(0, -1, 0)));
  return compound({grid(floor, {0.0, 1.0}, {0.0, 1.0}, {}, Joint::Loose),
                   grid(wall, {-20.0, 0.0}, {0.0, 10.0}, {}, Joint::Loose)});
}
BlendPicks planesPicks(const TopoDS_Shape& shape, std::array<double, 2> setback) {
  return between(shape, {0, 10, 0}, {12, 10, 9}, setback);
}

TEST(Setback, OfAnOpenSideReachesTheBorderOfItsFace) {
  for (const double widening : {-4.0, 0.0, 4.0}) {
    const TopoDS_Shape shape = planes(widening);
    const BlendPicks picks = planesPicks(shape, {3.0, 1.0});
    const ShapeFill blend = blended(shape, picks, ResultMode::Base);
    EXPECT_TRUE(blend.fill.report.withinTolerance) << widening;
    EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid()) << widening;
    const double wider = 0.3 * widening;
    double least = 1e9, most = -1e9;
    for (int k = 0; k <= kSamples; ++k) {
      const Vector3d p = onSide(blend, true, k);
      EXPECT_NEAR(p.x(), -3.0, 1e-6) << widening;
      least = std::min(least, p.y());
      most = std::max(most, p.y());
    }
    EXPECT_NEAR(least, -wider, 1e-5);
    EXPECT_NEAR(most, 20.0 + wider, 1e-5);
  }
}

/// The part of a ball's surface that lies up to `height` along the frame's axis.
TopoDS_Shape bowl(double radius, const gp_Ax3& frame, double height) {
  const TopoDS_Shape lower = BRepPrimAPI_MakeCylinder(
      gp_Ax2(frame.Location().Translated(-30.0 * gp_Vec(frame.Direction())), frame.Direction()),
      30.0,
      30.0 + height);
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(radius);
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(BRepAlgoAPI_Common(ball, lower).Shape(), TopAbs_FACE); it.More();
       it.Next())
    if (BRepAdaptor_Surface(TopoDS::Face(it.Current())).GetType() == GeomAbs_Sphere)
      faces.push_back(it.Current());
  return compound(faces);
}

// The curve at a distance from a slanted section of a sphere is no iso-curve: great circles that
// leave the section perpendicularly end on a parallel section.
TEST(Setback, OfAnyCurveIsMeasuredAlongTheFace) {
  const gp_Ax3 tilted(gp_Pnt(0, 0, 0), gp_Dir(std::sin(0.4), 0, std::cos(0.4)));
  const TopoDS_Shape shape = compound({bowl(10.0, tilted, 3.0), can(4.0, 16, 20, 20)});
  const Vector3d axis(std::sin(0.4), 0, std::cos(0.4));
  const Vector3d across(std::cos(0.4), 0, -std::sin(0.4));
  const double rim = std::sqrt(91.0);
  const BlendPicks picks = between(shape, 3.0 * axis - rim * across, {-4, 0, 16}, {2.0, 0.0});
  const ShapeFill blend = blended(shape, picks, ResultMode::Base);
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
  const double height = 10.0 * std::sin(std::asin(0.3) - 0.2);
  for (int k = 0; k <= kSamples; ++k) EXPECT_NEAR(onSide(blend, true, k).dot(axis), height, 1e-4);
}

TEST(Setback, SaysHowFarAFaceLetsItGo) {
  const TopoDS_Shape shape = planes(0.0);
  for (const auto& [tried, picks] : {std::pair{cans(), cansPicks({7.0, 0.0})},
                                     std::pair{shape, planesPicks(shape, {12.0, 0.0})}}) {
    const auto result = tryBlend(tried, picks);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::SetbackTooLarge);
    EXPECT_EQ(result.error().edge, picks.from.front());
    const double depth = picks.setback[0] == 7.0 ? 6.0 : 10.0;
    EXPECT_NEAR(result.error().value, depth, 1e-4 * depth);
  }
  const auto negative = tryBlend(cans(), cansPicks({-1.0, 0.0}));
  ASSERT_FALSE(negative.has_value());
  EXPECT_EQ(negative.error().code, ErrorCode::SetbackNegative);
}

}  // namespace
}  // namespace fairing::occt
