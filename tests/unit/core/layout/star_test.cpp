// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/star.h"

#include <gmock/gmock.h>

#include "support/many_sided_loops.h"
#include "support/matchers.h"

namespace fairing::layout {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using Eigen::Vector3d;

class Corners : public ::testing::TestWithParam<int> {
 protected:
  boundary::BoundaryLoop loop_ = finished(polygonOn(plane(), GetParam()));
  Result<LayoutPlan> plan_ = starPlan(loop_, cornerRoles(loop_));
};

TEST_P(Corners, HaveAPatchEachBetweenTwoSpokes) {
  ASSERT_TRUE(plan_.has_value());
  EXPECT_EQ(plan_->mesh.quads.size(), loop_.sides.size());
  EXPECT_EQ(plan_->mesh.seams().size(), loop_.sides.size());
  EXPECT_EQ(plan_->cut.loop.sides.size(), 2 * loop_.sides.size());
}

TEST_P(Corners, AlternateWithTheMiddlesOfTheSides) {
  ASSERT_TRUE(plan_.has_value());
  for (std::size_t k = 0; k < loop_.sides.size(); ++k) {
    const Vector3d spoke = plan_->cut.loop.sides[2 * k].ribbon.curve(0.0).point;
    const Vector3d corner = plan_->cut.loop.sides[2 * k].ribbon.curve(1.0).point;
    const std::size_t before = (k + loop_.sides.size() - 1) % loop_.sides.size();
    EXPECT_THAT(spoke, IsNear(loop_.sides[before].ribbon.curve(0.5).point, 1e-9));
    EXPECT_THAT(corner, IsNear(loop_.sides[k].ribbon.curve(0.0).point, 1e-9));
  }
}

INSTANTIATE_TEST_SUITE_P(Star, Corners, ::testing::Values(3, 4, 5, 6, 8, 10));

TEST(Star, NeedsThreeCorners) {
  const auto loop = finished(circleOn(plane(), 1.0));
  EXPECT_THAT(starPlan(loop, cornerRoles(loop)), FailsWith(ErrorCode::WrongSideCount));
}

TEST(Star, TakesOneSplitPlaceBetweenTwoCornersAndNoMore) {
  const auto loop = finished(polygonOn(plane(), 6));
  using enum CornerRole;
  const auto one = starPlan(loop, {Corner, Split, Corner, Corner, Corner, Corner});
  ASSERT_TRUE(one.has_value());
  EXPECT_EQ(one->mesh.quads.size(), 5U);
  EXPECT_THAT(starPlan(loop, {Corner, Split, Split, Corner, Corner, Corner}),
              FailsWith(ErrorCode::LayoutUnfit));
}

}  // namespace
}  // namespace fairing::layout
