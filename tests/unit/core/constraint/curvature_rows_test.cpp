// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/curvature_rows.h"

#include <gmock/gmock.h>

#include "core/fill/fill_hole.h"
#include "support/many_sided_loops.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

struct CurvedHole {
  const char* name;
  Sides (*sides)();
  std::size_t patches;
};

class CurvedHoles : public ::testing::TestWithParam<CurvedHole> {};

TEST_P(CurvedHoles, AreMetWithEqualCurvatureWhereThatIsAsked) {
  const auto loop = finished(asking(GetParam().sides(), Continuity::G2));
  const auto fill = fillHole(loop, {});
  ASSERT_TRUE(fill.has_value());
  EXPECT_EQ(fill->patches.size(), GetParam().patches);
  EXPECT_LE(fill->report.largestCurvature, 0.01);
  EXPECT_LE(fill->report.largestAngle, 0.02);
  EXPECT_LE(fill->report.largestSeamAngle, 0.02);
  EXPECT_TRUE(fill->report.withinTolerance);
  for (const auto& side : fill->report.sides) EXPECT_GT(side.curvature.count, 0);
}

INSTANTIATE_TEST_SUITE_P(
    CurvatureRows,
    CurvedHoles,
    ::testing::Values(
        CurvedHole{"SphereOctant", [] { return sphereOctant(10.0); }, 3},
        CurvedHole{
            "Torus", [] { return sidesOf(torus(5.0, 2.0), rectangle(0.0, 0.8, -0.5, 0.9)); }, 1},
        CurvedHole{"RoundHole", [] { return circleOn(waves(), 0.8); }, 5}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(CurvatureRows, AreNeverAskedOfSidesThatWantLess) {
  const auto loop = finished(asking(sphereOctant(10.0), Continuity::G1));
  const auto fill = fillHole(loop, {});
  ASSERT_TRUE(fill.has_value());
  EXPECT_EQ(fill->report.largestCurvature, 0.0);
}

}  // namespace
}  // namespace fairing
