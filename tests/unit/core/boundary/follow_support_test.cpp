// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/follow_support.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/known_loops.h"
#include "support/matchers.h"

namespace fairing::boundary {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using Eigen::Vector3d;

constexpr double kAngle = 0.02;  // degrees

// The unit square in the plane, its first edge waving about the plane by `height` mm: `waves` whole
// waves, level with the plane at both ends.
BoundaryLoop wavingLoop(double height, int waves) {
  Sides sides = sidesOf(plane(), unitSquare());
  const double rate = 2.0 * std::numbers::pi * waves;
  sides[0].ribbon.curve = [height, rate](double t) {
    return CurveSample{{t, 0.0, height * std::pow(std::sin(rate * t), 2)},
                       {1.0, 0.0, height * rate * std::sin(2.0 * rate * t)}};
  };
  sides[0].supportDeviation = height;
  return finished(sides);
}

double largestDeparture(const BoundarySide& side) {
  double worst = 0.0;
  for (int k = 0; k <= 400; ++k) {
    const double t = k / 400.0;
    const Vector3d along = side.ribbon.curve(t).derivative.normalized();
    worst = std::max(worst, std::asin(std::abs(along.dot(side.ribbon.support(t).normal))));
  }
  return worst * 180.0 / std::numbers::pi;
}

TEST(FollowSupports, LeavesEdgesOnTheirFacesAlone) {
  const BoundaryLoop loop = loopOf(waves(), unevenQuadrilateral(), 0.05);
  const BoundaryLoop followed = followSupports(loop, kAngle, kAngle);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(followed.sides[k].followedBy, 0.0);
    EXPECT_EQ(followed.sides[k].ribbon.curve(0.3).point, loop.sides[k].ribbon.curve(0.3).point);
  }
}

TEST(FollowSupports, BringsAWavingEdgeWithinTheAngle) {
  const BoundaryLoop loop = wavingLoop(5e-5, 2);
  ASSERT_GT(largestDeparture(loop.sides[0]), 1.5 * kAngle);
  const BoundaryLoop followed = followSupports(loop, kAngle, kAngle);
  // A share of the way fitted to 2 %: a little more than the limit may be left.
  EXPECT_LT(largestDeparture(followed.sides[0]), 1.2 * kAngle);
  EXPECT_GT(followed.sides[0].followedBy, 0.0);
  EXPECT_LT(followed.sides[0].followedBy, 5e-5);
  EXPECT_EQ(followed.sides[1].followedBy, 0.0);
}

TEST(FollowSupports, MovesNoFurtherThanItSays) {
  const BoundaryLoop loop = wavingLoop(5e-5, 2);
  const BoundarySide before = loop.sides[0];
  const BoundarySide after = followSupports(loop, kAngle, kAngle).sides[0];
  for (int k = 0; k <= 100; ++k) {
    const double t = k / 100.0;
    const double way = (after.ribbon.curve(t).point - before.ribbon.curve(t).point).norm();
    EXPECT_LT(way, 1.05 * after.followedBy);  // the fit's 2 %, and a margin
  }
}

TEST(FollowSupports, KeepsTheEnds) {
  const BoundaryLoop loop = wavingLoop(5e-5, 2);
  const BoundarySide after = followSupports(loop, kAngle, kAngle).sides[0];
  EXPECT_THAT(after.ribbon.curve(0.0).point, IsNear(Vector3d(0.0, 0.0, 0.0), 1e-12));
  EXPECT_THAT(after.ribbon.curve(1.0).point, IsNear(Vector3d(1.0, 0.0, 0.0), 1e-12));
}

TEST(FollowSupports, AnEdgeFarOffItsFaceCounts) {
  const BoundaryLoop followed = followSupports(wavingLoop(1e-2, 2), kAngle, kAngle);
  EXPECT_EQ(followed.sides[0].followedBy, 0.0);
}

TEST(FollowSupports, G0SidesFollowNothing) {
  BoundaryLoop loop = wavingLoop(5e-5, 2);
  loop.sides[0].continuity = Continuity::G0;
  EXPECT_EQ(followSupports(loop, kAngle, kAngle).sides[0].followedBy, 0.0);
}

}  // namespace
}  // namespace fairing::boundary
