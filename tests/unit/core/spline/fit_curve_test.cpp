// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/fit_curve.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::spline {
namespace {

using ::fairing::testing::IsNear;
using ::fairing::testing::Random;
using ::fairing::testing::randomCurve;
using ::fairing::testing::randomKnots;

CurvePoint helix(double t) {
  return {{std::cos(2.0 * t), std::sin(2.0 * t), t},
          {-2.0 * std::sin(2.0 * t), 2.0 * std::cos(2.0 * t), 1.0}};
}

KnotVector uniform(int degree, int spans) {
  std::vector<double> breaks;
  for (int s = 0; s <= spans; ++s) breaks.push_back(static_cast<double>(s) / spans);
  return KnotVector::fromBreaks(degree, breaks);
}

TEST(FitCurve, MeetsTheEndsInPositionAndDerivative) {
  const BsplineCurve curve = fitCurve(helix, uniform(5, 3)).curve;
  for (const double t : {0.0, 1.0}) {
    EXPECT_THAT(curve.evaluate(t), IsNear(helix(t).point, 1e-15));
    EXPECT_THAT(curve.evaluate(t, 1), IsNear(helix(t).derivative, 1e-13));
  }
}

TEST(FitCurve, GivesBackACurveOnTheSameKnots) {
  Random random{0};
  const BsplineCurve given = randomCurve(random, randomKnots(random, 4, 5));
  const auto function = [&](double t) {
    return CurvePoint{given.evaluate(t), given.evaluate(t, 1)};
  };
  const CurveFit fit = fitCurve(function, given.knots);
  // The normal equations' condition number is about 1e3.
  EXPECT_THAT(fit.curve.poles, IsNear(given.poles, 1e-11));
  EXPECT_LT(fit.error(), 1e-11);
}

TEST(FitCurve, ReportsTheErrorItMakes) {
  const CurveFit fit = fitCurve(helix, uniform(3, 2));
  double worst = 0.0;
  for (int k = 0; k <= 400; ++k) {
    const double t = k / 400.0;
    worst = std::max(worst, (fit.curve.evaluate(t) - helix(t).point).norm());
  }
  // Five points a span against two hundred: the maximum between them is missed by a little.
  EXPECT_NEAR(fit.error(), worst, 0.1 * worst);
}

TEST(FitCurve, ErrorOfEverySpanIsItsOwn) {
  // A bend only in the last half: what it does to the first span fades by a half or more a span.
  const auto bent = [](double t) {
    const double x = std::max(0.0, t - 0.5), x4 = x * x * x * x;
    return CurvePoint{{t, 300.0 * x * x4 * x, 0.0}, {1.0, 1800.0 * x * x4, 0.0}};
  };
  const CurveFit fit = fitCurve(bent, uniform(3, 12));
  ASSERT_EQ(fit.spanErrors.size(), 12U);
  EXPECT_LT(fit.spanErrors.front(), 0.05 * fit.spanErrors.back());
}

class FitCurveRate : public ::testing::TestWithParam<int> {};

TEST_P(FitCurveRate, FallsWithOrderDegreePlusOne) {
  const int degree = GetParam();
  const double coarse = fitCurve(helix, uniform(degree, 4)).error();
  const double fine = fitCurve(helix, uniform(degree, 8)).error();
  // The rate is degree + 1 as the spans tend to nothing; at 4 spans it is reached to half an order.
  EXPECT_GT(std::log2(coarse / fine), degree + 0.5);
}

INSTANTIATE_TEST_SUITE_P(Degrees, FitCurveRate, ::testing::Values(3, 4, 5, 6));

}  // namespace
}  // namespace fairing::spline
