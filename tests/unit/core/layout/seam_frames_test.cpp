// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/seam_frames.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/layout/layouts.h"
#include "support/many_sided_loops.h"

namespace fairing::layout {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

class RegularStars : public ::testing::TestWithParam<int> {};

TEST_P(RegularStars, LeaveTheirCentreByTheAngleOfTheirSpokes) {
  const int n = GetParam();
  const auto plan = planLayout(finished(polygonOn(plane(), n)), LayoutKind::Star);
  ASSERT_TRUE(plan.has_value());
  const auto seams = plan->mesh.seams();
  ASSERT_EQ(seams.size(), static_cast<std::size_t>(n));
  for (const QuadSeam& from : seams) {
    const Seam seam = seamOf(*plan, from);
    ASSERT_NE(seam.inside[0], seam.inside[1]);
    const std::size_t centre = seam.inside[0] ? 0 : 1;
    // The way out is e at the start of a seam and -e at its end.
    const double out = centre == 0 ? 1.0 : -1.0;
    EXPECT_NEAR(seam.frames[centre].first, 1.0, 1e-9);
    EXPECT_NEAR(seam.frames[centre].second, 1.0, 1e-9);
    EXPECT_NEAR(seam.frames[centre].along, out * 2.0 * std::cos(2.0 * std::numbers::pi / n), 1e-9);
    const SeamFrame& border = seam.frames[1 - centre];
    EXPECT_NEAR(border.first, 1.0, 1e-9);
    EXPECT_NEAR(border.second, 1.0, 1e-9);
    EXPECT_NEAR(border.along, 0.0, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(SeamFrames, RegularStars, ::testing::Values(3, 4, 5, 6, 8, 10));

TEST(SeamFrames, DeriveTheFrame) {
  Seam seam;
  seam.frames = {SeamFrame{1.2, 0.8, -0.7}, SeamFrame{0.9, 1.1, 0.4}};
  constexpr double kStep = 1e-5;
  for (const double t : {0.1, 0.5, 0.9}) {
    const SeamFrame a = seam.frame(t - kStep), b = seam.frame(t + kStep);
    const SeamFrame d = seam.frameDerivative(t);
    EXPECT_NEAR(d.first, (b.first - a.first) / (2.0 * kStep), 1e-9);
    EXPECT_NEAR(d.second, (b.second - a.second) / (2.0 * kStep), 1e-9);
    EXPECT_NEAR(d.along, (b.along - a.along) / (2.0 * kStep), 1e-9);
  }
}

}  // namespace
}  // namespace fairing::layout
