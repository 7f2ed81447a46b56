// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/optimise_patch.h"

#include <gtest/gtest.h>

#include "support/known_nets.h"

namespace fairing::uniform_patch {
namespace {

using namespace ::fairing::testing;  // NOLINT: nets

// How far a patch over the square from -1 to 1 bulges out over its border.
double hernia(const ControlNet& net) {
  double widest = 0.0;
  for (double u = 3.0; u <= net.rows; u += 0.25)
    for (double v = 3.0; v <= net.columns; v += 0.25)
      widest = std::max(widest, evaluate(net, u, v).head<2>().cwiseAbs().maxCoeff());
  return widest - 1.0;
}

PatchOptions stretched(double z) {
  PatchOptions options;
  options.transformation(2, 2) = z;
  return options;
}

TEST(OptimisePatch, StartsWhereItIsToldAndEndsAtTheSame) {
  PatchOptions coons, given;
  coons.start = PatchStart::Coons;
  given.start = PatchStart::Given;
  const double value = optimisePatch(waveNet(12, 12))->report.value();
  EXPECT_NEAR(optimisePatch(waveNet(12, 12), coons)->report.value(), value, 1e-9 * value);
  EXPECT_NEAR(optimisePatch(waveNet(12, 12), given)->report.value(), value, 1e-9 * value);
}

TEST(OptimisePatch, OfTheTriharmonicFunctionalIsOneLinearSystem) {
  PatchOptions options;
  options.functional = PatchFunctional::Triharmonic;
  const BlendingResult result = *optimisePatch(disturbed(cubicNet(12, 12), 1.0), options);
  EXPECT_LT((result.net.points - cubicNet(12, 12).points).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_TRUE(result.report.steps.empty());
}

// [Kiciak2011] section 6: on steep sides a bubble has less S than what anybody would draw.
TEST(OptimisePatch, GrowsAHerniaOnSteepSides) {
  EXPECT_GT(hernia(optimisePatch(plateauNet(18))->net), 0.3);
}

TEST(OptimisePatch, GrowsNoneInFlattenedSpace) {
  EXPECT_LT(hernia(optimisePatch(plateauNet(18), stretched(0.5))->net), 1e-3);
}

TEST(OptimisePatch, GrowsNoneBesideCurvesThatStay) {
  PatchOptions options;
  options.curves = {{FixedCurve::Constant::U, 10.5}, {FixedCurve::Constant::V, 10.5}};
  EXPECT_LT(hernia(optimisePatch(plateauNet(18), options)->net), 1e-3);
}

TEST(OptimisePatch, KeepsTheGivenCurvesFromAnyStartAndInAnySpace) {
  PatchOptions options = stretched(0.5);
  options.start = PatchStart::Coons;
  options.curves = {{FixedCurve::Constant::U, 6.0}, {FixedCurve::Constant::U, 9.0}};
  const ControlNet given = waveNet(12, 12);
  const BlendingResult result = *optimisePatch(given, options);
  EXPECT_EQ(result.report.outcome, BlendingOutcome::Converged);
  for (const double u : {6.0, 9.0})
    for (double v = 3.0; v <= 12.0; v += 0.4)
      EXPECT_LT((evaluate(result.net, u, v) - evaluate(given, u, v)).norm(), 1e-12);
}

TEST(OptimisePatch, RefusesToFlattenSpace) {
  const auto refused = optimisePatch(waveNet(9, 9), stretched(0.0));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::SystemSingular);
}

}  // namespace
}  // namespace fairing::uniform_patch
