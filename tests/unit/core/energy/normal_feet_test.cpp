// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/normal_feet.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::energy {
namespace {

using namespace ::fairing::testing;  // NOLINT: random splines
using Eigen::Vector3d;
using spline::KnotVector;

constexpr double kRadius = 0.4;

// The squares [0, 1] x [0, 1] and [1, 2] x [0, 1] in the plane.
std::vector<spline::BsplineSurface> twoSquares() {
  const KnotVector knots = KnotVector::fromBreaks(3, {0.0, 0.4, 1.0});
  const auto square = [&](double x) {
    return interpolated([x](double u, double v) { return Vector3d(x + u, v, 0.0); }, knots, knots);
  };
  return {square(0.0), square(1.0)};
}

Vector3d leaning(double degrees) {
  const double a = degrees * M_PI / 180.0;
  return {std::sin(a), 0.0, std::cos(a)};
}

double fade(double distance) {
  const double x = distance / kRadius;
  return (1.0 - x * x) * (1.0 - x * x);
}

TEST(NormalFeet, CountTheRadiusFromBelowTheHandle) {
  Guidance guidance;
  guidance.handles = {{Vector3d(0.5, 0.5, 3.0), leaning(20), 2.0, kRadius}};
  const NormalFeet feet(guidance, twoSquares());
  EXPECT_NEAR(feet.at({0.5, 0.5, 0.0}).lambda, 2.0, 1e-9);
  EXPECT_NEAR(feet.at({0.5, 0.7, 0.0}).lambda, 2.0 * fade(0.2), 1e-9);
  EXPECT_EQ(feet.at({0.5, 0.95, 0.0}).lambda, 0.0);
  EXPECT_THAT(feet.at({0.5, 0.7, 0.0}).normal, IsNear(leaning(20), 1e-14));
}

TEST(NormalFeet, ReachFromPatchToPatch) {
  Guidance guidance;
  guidance.handles = {{Vector3d(0.9, 0.5, 0.0), leaning(20), 1.0, kRadius}};
  EXPECT_NEAR(NormalFeet(guidance, twoSquares()).at({1.1, 0.5, 0.0}).lambda, fade(0.2), 1e-9);
}

TEST(NormalFeet, ThatAgreeWeighAsOne) {
  Guidance guidance;
  const NormalHandle handle{Vector3d(0.5, 0.5, 0.0), leaning(20), 3.0, kRadius};
  guidance.handles = {handle, handle};
  guidance.handles[1].normal *= -1.0;  // N and -N are the same
  const GuidanceSample there = NormalFeet(guidance, twoSquares()).at(handle.point);
  EXPECT_NEAR(there.lambda, 3.0, 1e-9);
  EXPECT_NEAR(std::abs(there.normal.dot(leaning(20))), 1.0, 1e-12);
}

TEST(NormalFeet, FadeIntoEachOther) {
  Guidance guidance;
  guidance.handles = {{Vector3d(0.4, 0.5, 0.0), leaning(-20), 1.0, kRadius},
                      {Vector3d(0.6, 0.5, 0.0), leaning(20), 1.0, kRadius}};
  const NormalFeet feet(guidance, twoSquares());
  EXPECT_THAT(feet.at({0.5, 0.5, 0.0}).normal, IsNear(leaning(0), 1e-9));
  EXPECT_GT(feet.at({0.55, 0.5, 0.0}).normal.x(), 0.0);
  EXPECT_LT(feet.at({0.55, 0.5, 0.0}).normal.x(), leaning(20).x());
}

TEST(NormalFeet, OfACurveGuideAllAlongIt) {
  Guidance guidance;
  guidance.curves = {{{Vector3d(0.2, 0.5, 1.0), Vector3d(1.8, 0.5, 1.0)},
                      {leaning(0), leaning(30)},
                      1.0,
                      kRadius}};
  const NormalFeet feet(guidance, twoSquares());
  for (const double x : {0.3, 1.0, 1.7}) {
    EXPECT_NEAR(feet.at({x, 0.6, 0.0}).lambda, fade(0.1), 1e-9);
    const double share = (x - 0.2) / 1.6;
    const Vector3d between = (1.0 - share) * leaning(0) + share * leaning(30);
    EXPECT_THAT(feet.at({x, 0.5, 0.0}).normal, IsNear(between.normalized(), 1e-9));
  }
}

TEST(NormalFeet, WithoutWeightAreAsIfTheyWereNotThere) {
  Guidance guidance;
  guidance.lambda = 1.0;
  guidance.handles = {{Vector3d(0.5, 0.5, 0.0), leaning(20), 1.0, kRadius},
                      {Vector3d(0.6, 0.5, 0.0), leaning(-20), 0.0, kRadius},
                      {Vector3d(9.0, 9.0, 0.0), leaning(0), 0.0, kRadius}};
  Guidance alone = guidance;
  alone.handles.resize(1);
  const NormalFeet feet(guidance, twoSquares()), known(alone, twoSquares());
  for (const double x : {0.5, 0.6, 0.7}) {
    EXPECT_EQ(feet.at({x, 0.5, 0.0}).normal, known.at({x, 0.5, 0.0}).normal);
    EXPECT_EQ(feet.at({x, 0.5, 0.0}).lambda, known.at({x, 0.5, 0.0}).lambda);
  }
  EXPECT_FALSE(feet.idle({Vector3d(0.5, 0.5, 0.0)}).has_value());
  guidance.handles.erase(guidance.handles.begin());
  EXPECT_FALSE(guidance.acts());
}

TEST(NormalFeet, TellWhatGuidesNothing) {
  Guidance guidance;
  guidance.handles = {{Vector3d(0.5, 0.5, 0.0), leaning(0), 1.0, kRadius}};
  guidance.curves = {{{Vector3d(0.5, 3.0, 0.0)}, {leaning(0)}, 1.0, kRadius}};
  const auto idle = NormalFeet(guidance, twoSquares()).idle({Vector3d(0.5, 0.5, 0.0)});
  ASSERT_TRUE(idle.has_value());
  EXPECT_TRUE(idle->isCurve);
  EXPECT_EQ(idle->number, 1);
  EXPECT_NEAR(idle->distance, 2.0, 1e-9);
  guidance.curves.clear();
  EXPECT_FALSE(NormalFeet(guidance, twoSquares()).idle({Vector3d(0.5, 0.5, 0.0)}).has_value());
  EXPECT_TRUE(NormalFeet(guidance, twoSquares()).idle({Vector3d(0.5, 0.0, 0.0)}).has_value());
}

}  // namespace
}  // namespace fairing::energy
