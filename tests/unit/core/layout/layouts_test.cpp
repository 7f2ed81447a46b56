// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/layouts.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "support/known_loops.h"
#include "support/matchers.h"

namespace fairing::layout {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

boundary::BoundaryLoop polygon(int count) {
  const auto corner = [count](int k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    return Eigen::Vector2d(std::cos(angle), std::sin(angle));
  };
  Sides sides;
  for (int k = 0; k < count; ++k)
    sides.push_back(sideOn(plane(), line(corner(k), corner(k + 1)), k));
  return finished(sides);
}

class CornersAndKind : public ::testing::TestWithParam<std::pair<int, LayoutKind>> {};

TEST_P(CornersAndKind, AutoTakesTheKindThatSuits) {
  const auto plan = planLayout(polygon(GetParam().first), LayoutKind::Auto);
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(plan->kind, GetParam().second);
}

INSTANTIATE_TEST_SUITE_P(Layouts,
                         CornersAndKind,
                         ::testing::Values(std::pair{3, LayoutKind::Star},
                                           std::pair{4, LayoutKind::Quad},
                                           std::pair{5, LayoutKind::Star},
                                           std::pair{8, LayoutKind::Star}));

class NoQuad : public ::testing::TestWithParam<int> {};

TEST_P(NoQuad, IsReportedWithTheNumberOfCorners) {
  const auto plan = planLayout(polygon(GetParam()), LayoutKind::Quad);
  ASSERT_THAT(plan, FailsWith(ErrorCode::WrongSideCount));
  EXPECT_EQ(plan.error().value, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Layouts, NoQuad, ::testing::Values(3, 5, 6));

TEST(Layouts, MoreThan64SidesAreTooMany) {
  EXPECT_THAT(planLayout(polygon(65), LayoutKind::Auto), FailsWith(ErrorCode::TooManySides));
}

TEST(Layouts, EdgesThatGoStraightOnAreOneSide) {
  Sides sides;
  const Eigen::Vector2d corners[] = {{0.0, 0.0}, {0.4, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  for (int k = 0; k < 5; ++k)
    sides.push_back(sideOn(plane(), line(corners[k], corners[(k + 1) % 5]), k));
  const auto plan = planLayout(finished(sides), LayoutKind::Auto);
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(plan->kind, LayoutKind::Quad);
  EXPECT_THAT(plan->cut.loop.sides[0].ribbon.curve(0.7).point,
              IsNear(Eigen::Vector3d(0.7, 0.0, 0.0), 1e-12));
}

// An L: five convex corners and a re-entrant one, where a spoke ends.
TEST(Layouts, ASpokeEndsInAReentrantCorner) {
  Sides sides;
  const Eigen::Vector2d corners[] = {
      {0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}};
  for (int k = 0; k < 6; ++k)
    sides.push_back(sideOn(plane(), line(corners[k], corners[(k + 1) % 6]), k));
  const auto plan = planLayout(finished(sides), LayoutKind::Auto);
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(plan->kind, LayoutKind::Star);
  EXPECT_EQ(plan->mesh.quads.size(), 5U);
  int ends = 0;
  for (std::size_t k = 0; k < plan->cut.loop.sides.size(); k += 2) {
    const Eigen::Vector3d end = plan->cut.loop.sides[k].ribbon.curve(0.0).point;
    if ((end - Eigen::Vector3d(1.0, 1.0, 0.0)).norm() < 1e-12) ++ends;
  }
  EXPECT_EQ(ends, 1);
}

}  // namespace
}  // namespace fairing::layout
