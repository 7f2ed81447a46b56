// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/layouts.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

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

class WrongSideCount : public ::testing::TestWithParam<int> {};

TEST_P(WrongSideCount, IsReportedWithTheNumberFound) {
  const auto layout = makeLayout(polygon(GetParam()), {});
  ASSERT_THAT(layout, FailsWith(ErrorCode::WrongSideCount));
  EXPECT_EQ(layout.error().value, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Layouts, WrongSideCount, ::testing::Values(2, 3, 5, 6));

TEST(Layouts, FourSidesMakeAQuad) {
  const auto layout = makeLayout(polygon(4), {LayoutKind::Auto, 0, 1e-6, 1000});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->kind, LayoutKind::Quad);
  EXPECT_EQ(layout->patches.size(), 1U);
}

}  // namespace
}  // namespace fairing::layout
