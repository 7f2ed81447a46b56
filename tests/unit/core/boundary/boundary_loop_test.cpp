// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/boundary_loop.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/known_loops.h"
#include "support/matchers.h"

namespace fairing::boundary {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

constexpr double kDegrees = 180.0 / std::numbers::pi;

TEST(BoundaryLoop, CornerIIsWhereSideIEnds) {
  const BoundaryLoop loop = loopOf(waves(), unevenQuadrilateral());
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_THAT(loop.corners[k].point, IsNear(loop.sides[k].ribbon.curve(1.0).point, 1e-15));
    EXPECT_THAT(loop.corners[k].point,
                IsNear(loop.sides[(k + 1) % 4].ribbon.curve(0.0).point, 1e-15));
  }
}

TEST(BoundaryLoop, CornerAnglesAreThoseOfThePolygon) {
  const auto corners = unevenQuadrilateral();
  const BoundaryLoop loop = loopOf(plane(), corners);
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d at = corners[(k + 1) % 4];
    const Eigen::Vector2d back = (corners[k] - at).normalized();
    const Eigen::Vector2d on = (corners[(k + 2) % 4] - at).normalized();
    EXPECT_NEAR(loop.corners[k].angle, std::acos(back.dot(on)) * kDegrees, 1e-10);
    sum += loop.corners[k].angle;
  }
  EXPECT_NEAR(sum, 360.0, 1e-10);
}

TEST(BoundaryLoop, LengthsAreArcLengths) {
  // Parallels and meridians of a torus: arcs of known radius.
  const BoundaryLoop loop = loopOf(torus(5.0, 2.0), rectangle(0.0, 1.0, 0.0, 1.0));
  EXPECT_NEAR(loop.sides[0].length, 7.0, 1e-12);
  EXPECT_NEAR(loop.sides[1].length, 2.0, 1e-12);
  EXPECT_NEAR(loop.sides[2].length, 5.0 + 2.0 * std::cos(1.0), 1e-12);
  EXPECT_NEAR(loop.sides[3].length, 2.0, 1e-12);
}

TEST(BoundaryLoop, DiagonalIsTheLargestDistanceAcross) {
  EXPECT_NEAR(loopOf(plane(), rectangle(0.0, 3.0, 0.0, 4.0)).diagonal, 5.0, 1e-12);
}

TEST(BoundaryLoop, DiagonalDoesNotChangeWhenTheHoleIsTurned) {
  const Sides sides = sidesOf(plane(), rectangle(0.0, 3.0, 0.0, 4.0));
  const Eigen::Affine3d turn(Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, 3).normalized()));
  EXPECT_NEAR(finished(moved(sides, turn)).diagonal, 5.0, 1e-12);
}

TEST(BoundaryLoop, OneSmoothSupportAgreesWithItselfAtEveryCorner) {
  for (const Corner& corner : loopOf(waves(), unevenQuadrilateral(), 0.1).corners) {
    EXPECT_NEAR(corner.normalMismatch, 0.0, 1e-6);  // the square root of a rounding
    // One-sided differences of fourth order over 2e-3: about 1e-9 rad.
    EXPECT_NEAR(corner.twistMismatch, 0.0, 1e-6);
  }
}

TEST(BoundaryLoop, NormalMismatchIsTheAngleBetweenTheSupports) {
  Sides sides = sidesOf(plane(), unitSquare());
  sides[1].ribbon.support = [flat = sides[1].ribbon.support](double t) {
    SupportSample s = flat(t);
    s.normal = Eigen::AngleAxisd(3.0 / kDegrees, Eigen::Vector3d::UnitY()) * s.normal;
    return s;
  };
  const BoundaryLoop loop = finished(sides);
  EXPECT_NEAR(loop.corners[0].normalMismatch, 3.0, 1e-10);
  EXPECT_NEAR(loop.corners[1].normalMismatch, 3.0, 1e-10);
  EXPECT_NEAR(loop.corners[2].normalMismatch, 0.0, 1e-6);
  EXPECT_TRUE(loop.corners[0].normalsAgree(3.1));
  EXPECT_FALSE(loop.corners[0].normalsAgree(2.9));
}

TEST(BoundaryLoop, TwistMismatchIsTheRateOfTurnThatDiffers) {
  // Every support turns by 0.2 rad a unit where its side starts and not at all where it ends.
  for (const Corner& corner : finished(incompatibleTwists(0.2)).corners)
    EXPECT_NEAR(corner.twistMismatch, 0.2 * kDegrees, 1e-6);
}

TEST(BoundaryLoop, TwistMismatchDoesNotDependOnTheSize) {
  const Sides sides = incompatibleTwists(0.2);
  const BoundaryLoop large = finished(moved(sides, Eigen::Affine3d(Eigen::Scaling(1e4))));
  EXPECT_NEAR(large.corners[0].twistMismatch, 0.2 * kDegrees, 1e-6);
}

TEST(BoundaryLoop, SidesThatAskForNoNormalsHaveNoMismatch) {
  Sides sides = incompatibleTwists(0.2);
  sides[0].continuity = Continuity::G0;
  const BoundaryLoop loop = finished(sides);
  EXPECT_EQ(loop.corners[0].twistMismatch, 0.0);
  EXPECT_EQ(loop.corners[3].twistMismatch, 0.0);
  EXPECT_GT(loop.corners[1].twistMismatch, 1.0);
}

TEST(BoundaryLoop, NothingMakesNoLoop) {
  EXPECT_THAT(makeLoop({}), FailsWith(ErrorCode::NothingPicked));
}

TEST(BoundaryLoop, AGapIsReportedWithItsPlaceAndSize) {
  Sides sides = sidesOf(plane(), unitSquare());
  sides[2] = sideOn(plane(), line({1.0, 1.1}, {0.0, 1.0}), 2);
  const auto loop = makeLoop(sides);
  ASSERT_THAT(loop, FailsWith(ErrorCode::LoopNotClosed));
  EXPECT_EQ(loop.error().edge, sides[1].edge);
  EXPECT_NEAR(loop.error().value, 0.1, 1e-12);
  ASSERT_TRUE(loop.error().where.has_value());
  EXPECT_THAT(*loop.error().where, IsNear(Eigen::Vector3d(1.0, 1.0, 0.0), 1e-12));
}

TEST(BoundaryLoop, CornersThatMissEachOtherByACadToleranceStillClose) {
  Sides sides = sidesOf(plane(), unitSquare());
  sides[2] = sideOn(plane(), line({1.0, 1.0 + 1e-4}, {0.0, 1.0}), 2);
  const BoundaryLoop loop = finished(sides);
  EXPECT_NEAR(loop.corners[1].gap, 1e-4, 1e-12);
}

TEST(BoundaryLoop, ASideWithoutLengthIsDegenerate) {
  Sides sides = sidesOf(plane(), unitSquare());
  sides.insert(sides.begin() + 1, sideOn(plane(), line({1.0, 0.0}, {1.0, 0.0}), 6));
  const auto loop = makeLoop(sides);
  ASSERT_THAT(loop, FailsWith(ErrorCode::EdgeDegenerate));
  EXPECT_EQ(loop.error().edge, 7);
}

TEST(BoundaryLoop, ACurveThatIsNotANumberIsReported) {
  Sides sides = sidesOf(plane(), unitSquare());
  sides[3].ribbon.curve = [](double) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return CurveSample{Eigen::Vector3d::Constant(nan), Eigen::Vector3d::Constant(nan)};
  };
  EXPECT_THAT(makeLoop(sides), FailsWith(ErrorCode::NotFinite));
}

TEST(BoundaryLoop, G1WithoutASupportFaceIsAnError) {
  Sides sides = sidesOf(plane(), unitSquare());
  sides[2].ribbon.support = {};
  const auto loop = makeLoop(sides);
  ASSERT_THAT(loop, FailsWith(ErrorCode::EdgeWithoutFace));
  EXPECT_EQ(loop.error().edge, sides[2].edge);
}

TEST(BoundaryLoop, G0NeedsNoSupportFace) {
  Sides sides = sidesOf(plane(), unitSquare());
  sides[2].ribbon.support = {};
  sides[2].continuity = Continuity::G0;
  EXPECT_TRUE(makeLoop(sides).has_value());
}

}  // namespace
}  // namespace fairing::boundary
