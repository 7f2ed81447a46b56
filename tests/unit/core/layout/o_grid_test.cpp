// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/o_grid.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "support/many_sided_loops.h"
#include "support/matchers.h"

namespace fairing::layout {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

constexpr double kRadius = 3.0;

Result<LayoutPlan> planOf(const boundary::BoundaryLoop& loop) {
  return oGridPlan(loop, cornerRoles(loop));
}

TEST(OGrid, DividesACircleInFourQuartersRoundAnInnerPatch) {
  for (const Sides& sides : {circleOn(plane(), kRadius), halfCirclesOn(plane(), kRadius)}) {
    const auto plan = planOf(finished(sides));
    ASSERT_TRUE(plan.has_value());
    ASSERT_EQ(plan->mesh.quads.size(), 5U);
    EXPECT_EQ(plan->mesh.seams().size(), 8U);
    ASSERT_EQ(plan->cut.loop.sides.size(), 4U);
    for (const boundary::BoundarySide& side : plan->cut.loop.sides)
      EXPECT_NEAR(side.length, 0.5 * std::numbers::pi * kRadius, 1e-6);
    const auto inner = std::count(plan->mesh.inside.begin(), plan->mesh.inside.end(), 1);
    EXPECT_EQ(inner, 4);
  }
}

TEST(OGrid, HasItsPlacesWhereTheLoopIsNotSmooth) {
  const auto loop = finished(polygonOn(plane(), 3));
  const auto plan = planOf(loop);
  ASSERT_TRUE(plan.has_value());
  for (const boundary::BoundarySide& edge : loop.sides) {
    double nearest = kRadius;
    for (const boundary::BoundarySide& side : plan->cut.loop.sides)
      nearest =
          std::min(nearest, (side.ribbon.curve(0.0).point - edge.ribbon.curve(0.0).point).norm());
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(OGrid, TakesFourSuchPlacesAtMost) {
  EXPECT_THAT(planOf(finished(polygonOn(plane(), 5))), FailsWith(ErrorCode::LayoutUnfit));
}

TEST(OGrid, NeedsNoHelpOnACircleButOnAPointedOval) {
  EXPECT_FALSE(bendsSharply(finished(circleOn(plane(), kRadius))));
  const KnownSurface squeezed = surfaceOf(
      [](const Jet2& u, const Jet2& v) { return JetPoint{u, Jet2(0.05) * v, Jet2(0.0)}; });
  EXPECT_TRUE(bendsSharply(finished(circleOn(squeezed, kRadius))));
}

}  // namespace
}  // namespace fairing::layout
