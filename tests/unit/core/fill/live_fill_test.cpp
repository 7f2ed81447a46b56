// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/live_fill.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/fill/fill_hole.h"
#include "core/spline/nearest_patch.h"
#include "support/known_loops.h"
#include "support/many_sided_loops.h"
#include "support/matchers.h"
#include "support/measure.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: known loops
using boundary::BoundaryLoop;
using Eigen::Vector3d;

constexpr double kLambda = 200.0;

struct KnownHole {
  const char* name;
  std::function<BoundaryLoop()> loop;
  LayoutKind layout;
};

// Under a handle that leans in the middle of the hole.
energy::Guidance leaning(double lambda, double degrees = 20.0) {
  const double a = degrees * M_PI / 180.0;
  energy::Guidance guidance;
  guidance.lambda = lambda;
  guidance.handles = {{Vector3d(0.1, 0.2, 0.0), Vector3d(std::sin(a), 0.0, std::cos(a)), 1.0, 0.5}};
  return guidance;
}

class LiveFills : public ::testing::TestWithParam<KnownHole> {
 protected:
  [[nodiscard]] FillOptions options(double lambda) const {
    FillOptions options;
    options.layout = GetParam().layout;
    options.guidance = leaning(lambda);
    return options;
  }
  [[nodiscard]] FillResult filled(double lambda) const {
    auto result = fillHole(loop_, options(lambda));
    EXPECT_TRUE(result.has_value());
    return result ? std::move(*result) : FillResult{};
  }

  BoundaryLoop loop_ = GetParam().loop();
};

double farthest(const Patches& from, const Patches& to) {
  const spline::NearestPatch nearest(to);
  double worst = 0.0;
  for (const spline::BsplineSurface& patch : from)
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j) {
        const double u = patch.u.first() + (patch.u.last() - patch.u.first()) * i / 8;
        const double v = patch.v.first() + (patch.v.last() - patch.v.first()) * j / 8;
        worst = std::max(worst, nearest.to(patch.evaluate(u, v)).foot.distance);
      }
  return worst;
}

TEST_P(LiveFills, AreThoseOfAWholeFillUnderTheSameWeight) {
  const FillResult start = filled(kLambda);
  LiveFill live(loop_, options(kLambda), start);
  ASSERT_TRUE(live.under(leaning(1.0)).has_value());
  // Looked up as often as a whole fill does.
  std::optional<FillResult> again;
  for (int k = 0; k < 6; ++k) again = *live.under(leaning(kLambda));
  EXPECT_LT(farthest(again->patches, start.patches), 2e-4 * loop_.diagonal);
  ASSERT_TRUE(again->report.guidance.has_value());
  EXPECT_NEAR(again->report.guidance->rmsAngle, start.report.guidance->rmsAngle, 0.05);
  EXPECT_NEAR(again->summary.energy, start.summary.energy, 1e-2 * start.summary.energy);
}

TEST_P(LiveFills, FollowMoreCloselyTheMoreTheGuideWeighs) {
  const FillResult start = filled(0.0);
  LiveFill live(loop_, options(0.0), start);
  double before = 90.0;
  for (const double lambda : {0.0, 1.0, 10.0, 50.0, 500.0}) {
    const auto moved = live.under(leaning(lambda), false);
    ASSERT_TRUE(moved.has_value());
    EXPECT_LT(moved->report.guidance->rmsAngle, before);
    before = moved->report.guidance->rmsAngle;
  }
}

TEST_P(LiveFills, StayOnTheirBorderAtAnyWeight) {
  const FillResult start = filled(0.0);
  LiveFill live(loop_, options(0.0), start);
  const auto moved = live.under(leaning(1e4), false);
  ASSERT_TRUE(moved.has_value());
  // The trimmed face meets its border in least squares, the others exactly or not at all.
  if (GetParam().layout == LayoutKind::Trimmed)
    EXPECT_LE(moved->report.largestGap, moved->report.gapLimit);
  else
    EXPECT_LE(moved->report.largestGap, 1.01 * start.report.largestGap + 1e-12 * loop_.diagonal);
}

INSTANTIATE_TEST_SUITE_P(
    Layouts,
    LiveFills,
    ::testing::Values(
        KnownHole{
            "Quad", [] { return loopOf(waves(), rectangle(-1, 1, -1, 1)); }, LayoutKind::Quad},
        KnownHole{"Star", [] { return finished(polygonOn(waves(), 5)); }, LayoutKind::Star},
        KnownHole{"OGrid", [] { return finished(circleOn(waves(), 1.0)); }, LayoutKind::OGrid},
        KnownHole{"Trimmed", [] { return finished(circleOn(waves(), 1.0)); }, LayoutKind::Trimmed}),
    [](const auto& instance) { return instance.param.name; });

TEST(LiveFill, MeetsCurvatureWhileItMoves) {
  const BoundaryLoop loop =
      finished(asking(sidesOf(waves(), rectangle(-1, 1, -1, 1)), Continuity::G2));
  FillOptions options;
  const auto start = fillHole(loop, options);
  ASSERT_TRUE(start.has_value());
  LiveFill live(loop, options, *start);
  const auto moved = live.under(leaning(20.0));
  ASSERT_TRUE(moved.has_value());
  EXPECT_LT(moved->report.largestCurvature, 0.05);
}

TEST(LiveFill, TellsOfAHandleThatIsOff) {
  const BoundaryLoop loop = loopOf(waves(), rectangle(-1, 1, -1, 1));
  const auto start = fillHole(loop, {});
  ASSERT_TRUE(start.has_value());
  LiveFill live(loop, {}, *start);
  energy::Guidance off = leaning(1.0);
  off.handles[0].point = {9.0, 0.0, 0.0};
  EXPECT_THAT(live.under(off), FailsWith(ErrorCode::HandleOff));
}

}  // namespace
}  // namespace fairing
