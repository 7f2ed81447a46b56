// SPDX-License-Identifier: LGPL-2.1-or-later
// How a blend leaves its sides: how far, which way, in which direction.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <cmath>
#include <numbers>

#include "core/boundary/constraint_normal.h"
#include "occt/bilinear.h"
#include "occt/blends.h"
#include "occt/shapes.h"
#include "text/error_text.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using boundary::Departure;
using boundary::Leaving;
using Eigen::Vector3d;

constexpr double kRound = 2.0 * std::numbers::pi;
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr int kSamples = 100;

struct Base {
  TopoDS_Shape shape;
  BlendPicks picks;
};

Base base(const TopoDS_Shape& shape,
          const Vector3d& from,
          const Vector3d& to,
          Continuity continuity = Continuity::G1) {
  return {shape, between(shape, from, to, continuity)};
}

ShapeFill blended(const Base& b, const BlendOptions& options = {}) {
  return testing::blended(b.shape, b.picks, ResultMode::Patches, options);
}

ErrorCode refusal(const Base& b, const BlendOptions& options) {
  return testing::refusal(b.shape, b.picks, options);
}

/// A pipe of radius 5, and one of radius 9 beside its axis and tilted against it.
Base tiltedPipes() {
  const double tilt = 20.0 / kDegrees;
  const gp_Ax3 frame(gp_Pnt(4, 2, 8),
                     gp_Dir(std::sin(tilt), 0, std::cos(tilt)),
                     gp_Dir(std::cos(tilt), 0, -std::sin(tilt)));
  return base(compound({pipe(upright(), 5.0, -14, -8), pipe(frame, 9.0, 0, 6)}),
              {-5, 0, -8},
              Vector3d(4, 2, 8) - 9.0 * Vector3d(std::cos(tilt), 0, -std::sin(tilt)));
}

TopoDS_Shape wall() {
  const Handle(Geom_Surface) plane =
      new Geom_Plane(gp_Ax3(gp_Pnt(12, 0, 9), gp_Dir(-1, 0, 0), gp_Dir(0, -1, 0)));
  return grid(plane, {-20.0, 0.0}, {0.0, 10.0}, {}, Joint::Loose);
}
const Vector3d kWallMiddle(12, 10, 9);

/// A floor x <= 0 and a wall above it.
Base twoPlanes(Continuity continuity = Continuity::G1) {
  const TopoDS_Shape floor =
      grid(new Geom_Plane(upright()), {-10.0, 0.0}, {0.0, 20.0}, {}, Joint::Loose);
  return base(compound({floor, wall()}), {0, 10, 0}, kWallMiddle, continuity);
}

/// The same with a floor that is a parallelogram: its iso-curves meet the edge x = 0 at 60 degrees.
Base slantedFloor() {
  const double slant = 10.0 / std::tan(60.0 / kDegrees);
  const Handle(Geom_Surface) surface =
      bilinear({-10, -slant, 0}, {-10, 20 - slant, 0}, {0, 0, 0}, {0, 20, 0});
  const TopoDS_Shape floor = grid(surface, {0.0, 1.0}, {0.0, 1.0}, {}, Joint::Loose);
  return base(compound({floor, wall()}), {0, 10, 0}, kWallMiddle);
}

/// The patch at a place of its first side, t along that side.
spline::SurfaceJet atFirst(const ShapeFill& blend, double t) {
  const auto& patch = blend.fill.patches.front();
  return patch.jet(t * patch.u.last(), 0.0);
}
double shareOf(int k) {
  return (k + 0.5) / kSamples;
}

void expectTangent(const ShapeFill& blend) {
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  EXPECT_LT(blend.fill.report.largestAngle, 0.02);
  EXPECT_LT(blend.fill.report.largestCurvature, 0.01);
}

TEST(BlendDeparture, ReachVariesLinearlyAlongASide) {
  for (const Continuity asked : {Continuity::G1, Continuity::G2}) {
    const ShapeFill plain = blended(twoPlanes(asked));
    const ShapeFill varied =
        blended(twoPlanes(asked), {.reach = {{1.2, 1.0}, {1.8, std::nullopt}}});
    expectTangent(varied);
    const auto error = [&](double t) {
      const double wanted = (1.2 + 0.6 * t) * atFirst(plain, t).v.norm();
      return std::abs(atFirst(varied, t).v.norm() - wanted) / wanted;
    };
    const spline::KnotVector knots = varied.fill.patches[0].u.mapped(0.0, 1.0);
    for (int i = 0; i < knots.poleCount(); ++i) EXPECT_LT(error(knots.greville(i)), 1e-9);
    // Between them as well as few knots can: the cross tangents vary by 10 % at the free ends.
    for (int k = 0; k < kSamples; ++k) EXPECT_LT(error(shareOf(k)), 1.5e-2);
  }
}

TEST(BlendDeparture, ReachThatIsTheSameAtBothEndsIsOneFactor) {
  const ShapeFill one = blended(twoPlanes(), {.reach = {{1.3, 1.0}}});
  const ShapeFill same = blended(twoPlanes(), {.reach = {{1.3, 1.0}, {1.3, 1.0}}});
  EXPECT_LT((one.fill.patches[0].poles - same.fill.patches[0].poles).norm(), 1e-9);
}

TEST(BlendDeparture, ReachOfAClosedSideCannotVary) {
  EXPECT_EQ(refusal(tiltedPipes(), {.reach = {{1.0, 1.0}, {1.5, std::nullopt}}}),
            ErrorCode::ReachVariesRound);
  EXPECT_EQ(refusal(twoPlanes(), {.reach = {{1.0, 1.0}, {std::nullopt, 0.0}}}),
            ErrorCode::ReachNotPositive);
}

/// Pipes one above the other; the edge taken of the lower one is its lower end, so that the blend
/// has to pass over it to reach the upper one.
Base lowerEnd(Continuity continuity = Continuity::G1) {
  return base(compound({pipe(upright(), 5.0, -8, -2), pipe(upright(), 9.0, 8, 14)}),
              {-5, 0, -8},
              {-9, 0, 8},
              continuity);
}

TEST(BlendDeparture, LeavesItsFaceUnlessFlipped) {
  for (const Continuity asked : {Continuity::G1, Continuity::G2}) {
    const ShapeFill onwards = blended(lowerEnd(asked));
    const ShapeFill flipped =
        blended(lowerEnd(asked), {.leaving = {Leaving::Backwards, Leaving::Onwards}});
    expectTangent(onwards);
    expectTangent(flipped);
    for (int k = 0; k < kSamples; ++k) {
      EXPECT_LT(atFirst(onwards, shareOf(k)).v.z(), 0.0);
      EXPECT_GT(atFirst(flipped, shareOf(k)).v.z(), 0.0);
    }
  }
}

TEST(BlendDeparture, AFlippedSideLeavesOverItsFace) {
  const ShapeFill flipped =
      blended(tiltedPipes(), {.leaving = {Leaving::Onwards, Leaving::Backwards}});
  EXPECT_LT(flipped.fill.report.largestAngle, 0.02);
  const boundary::Ribbon& ribbon = flipped.loop.sides[1].ribbon;
  const auto& patch = flipped.fill.patches.front();
  for (int k = 0; k < kSamples; ++k) {
    const auto jet = patch.jet(shareOf(k) * patch.u.last(), patch.v.last());
    double nearest = 0.0, least = 1e9;
    for (int i = 0; i <= 1000; ++i) {
      const double distance = (ribbon.curve(i / 1000.0).point - jet.point).norm();
      if (distance < least) least = distance, nearest = i / 1000.0;
    }
    const Vector3d left =
        boundary::constraintNormal(ribbon, nearest).cross(ribbon.curve(nearest).derivative);
    EXPECT_LT(-jet.v.dot(left), 0.0);
  }
}

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * kDegrees;
}

TEST(BlendDeparture, IsPerpendicularToTheEdgeWhereAsked) {
  for (const Base& b : {tiltedPipes(), slantedFloor()}) {
    const ShapeFill blend =
        blended(b, {.departure = {Departure::Perpendicular, Departure::Perpendicular}});
    expectTangent(blend);
    double largest = 0.0;
    const auto& patch = blend.fill.patches.front();
    for (int k = 0; k < kSamples; ++k)
      for (const double v : {0.0, patch.v.last()}) {
        const auto jet = patch.jet(shareOf(k) * patch.u.last(), v);
        largest = std::max(largest, 90.0 - angleBetween(jet.u, jet.v));
      }
    EXPECT_LT(largest, 0.1);
    EXPECT_NEAR(blend.fill.report.sides[0].departure.max, 0.0, 0.1);
    EXPECT_GT(blend.fill.report.sides[0].departure.count, 0);
  }
}

TEST(BlendDeparture, FollowsTheIsoCurvesWhereAsked) {
  const ShapeFill blend = blended(slantedFloor(), {.departure = {Departure::Iso, Departure::Free}});
  expectTangent(blend);
  for (int k = 0; k < kSamples; ++k) {
    const auto jet = atFirst(blend, shareOf(k));
    EXPECT_NEAR(angleBetween(jet.u, jet.v), 60.0, 0.1);
  }
}

TEST(BlendDeparture, KeepsItsDirectionWhenItReachesFarther) {
  const ShapeFill blend =
      blended(slantedFloor(),
              {.reach = {{1.2, 1.0}, {1.6, std::nullopt}}, .departure = {Departure::Iso, {}}});
  expectTangent(blend);
  EXPECT_LT(blend.fill.report.sides[0].departure.max, 0.1);
}

TEST(BlendDeparture, NeedsATangentSide) {
  Base b = twoPlanes();
  b.picks.edgeContinuity[b.picks.from.front()] = Continuity::G0;
  EXPECT_EQ(refusal(b, {.departure = {Departure::Perpendicular, {}}}),
            ErrorCode::DepartureNotTangent);
  EXPECT_EQ(refusal(b, {.leaving = {Leaving::Backwards, {}}}), ErrorCode::DepartureNotTangent);
}

}  // namespace
}  // namespace fairing::occt
