// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/loop_probe.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/known_loops.h"
#include "support/matchers.h"

namespace fairing::analysis {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

// A straight side run through with growing speed: t to (t + t^2) / 2.
Trace hurrying(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return [=](double t) {
    return TracePoint{from + 0.5 * (t + t * t) * (to - from), (0.5 + t) * (to - from)};
  };
}

boundary::BoundaryLoop hurryingLoop() {
  const auto c = unitSquare();
  Sides sides;
  for (std::size_t k = 0; k < 4; ++k)
    sides.push_back(sideOn(plane(), hurrying(c[k], c[(k + 1) % 4]), static_cast<int>(k)));
  return finished(sides);
}

TEST(LoopProbe, PlacesAreSpreadEvenlyOverTheArcLength) {
  const auto points = probeLoop(hurryingLoop(), hurryingLoop(), {}, {50, 0}).sides[0];
  // Without corner points: the two ends and the middles of 50 equal pieces of the inner 96 %.
  ASSERT_EQ(points.size(), 52U);
  for (std::size_t k = 1; k + 1 < points.size(); ++k)
    // Trapezoids over 64 steps: a quadratic arc length is off by less than 1e-4.
    EXPECT_NEAR(points[k].point[0], 0.02 + 0.96 * (static_cast<double>(k) - 0.5) / 50.0, 1e-4);
}

TEST(LoopProbe, CornerPlacesAreTheOuterTwoPercentOfTheLength) {
  const LoopProbe probe = probeLoop(hurryingLoop());
  for (const ProbePoint& p : probe.sides[0]) {
    const double along = p.point[0];
    EXPECT_EQ(p.inCorner, along < kCornerZone || along > 1.0 - kCornerZone) << "at " << along;
  }
}

TEST(LoopProbe, PlacesAscend) {
  for (const auto& side : probeLoop(loopOf(waves(), unevenQuadrilateral(), 0.1)).sides)
    for (std::size_t k = 0; k + 1 < side.size(); ++k) EXPECT_LT(side[k].t, side[k + 1].t);
}

TEST(LoopProbe, EndsHaveNoNormal) {
  for (const auto& side : probeLoop(loopOf(waves(), unitSquare())).sides) {
    EXPECT_EQ(side.front().t, 0.0);
    EXPECT_EQ(side.back().t, 1.0);
    EXPECT_FALSE(side.front().hasNormal);
    EXPECT_FALSE(side.back().hasNormal);
    EXPECT_TRUE(side[1].hasNormal);
  }
}

TEST(LoopProbe, CurvatureIsThatOfTheSupportAcrossTheSide) {
  // Sides of a cylinder's patch: across the arcs it is straight, across the lines it is round.
  const auto probe = probeLoop(loopOf(cylinder(2.0), rectangle(0.0, 1.0, 0.0, 1.0)));
  EXPECT_NEAR(probe.sides[0][20].curvature, 0.0, 1e-12);
  EXPECT_NEAR(probe.sides[1][20].curvature, -0.5, 1e-12);
}

TEST(LoopProbe, FloorIsTheAngleTheEdgeLeavesItsFaceBy) {
  const double tilt = 0.01;
  Sides sides = sidesOf(plane(), unitSquare());
  sides[0].ribbon.support = [flat = sides[0].ribbon.support, tilt](double t) {
    auto s = flat(t);
    s.normal = Eigen::Vector3d(std::sin(tilt), 0.0, std::cos(tilt));
    return s;
  };
  const auto probe = probeLoop(finished(sides));
  EXPECT_NEAR(probe.sides[0][30].floor, tilt * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(probe.sides[1][30].floor, 0.0, 1e-9);
}

}  // namespace
}  // namespace fairing::analysis
