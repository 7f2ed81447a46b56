// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/quadrature.h"

#include <gmock/gmock.h>

#include <cmath>

namespace fairing::spline {
namespace {

double integrate(const std::vector<QuadraturePoint>& points, int power) {
  double sum = 0.0;
  for (const auto& q : points) sum += q.weight * std::pow(q.parameter, power);
  return sum;
}

TEST(GaussLegendre, IsExactToTwiceThePointsLessOne) {
  for (int n = 1; n <= 20; ++n)
    for (int power = 0; power < 2 * n; ++power)
      EXPECT_NEAR(integrate(gaussLegendre(n, 0.0, 1.0), power), 1.0 / (power + 1), 1e-14)
          << n << " points, power " << power;
}

TEST(GaussLobatto, IsExactToTwiceThePointsLessThree) {
  for (int n = 2; n <= 20; ++n)
    for (int power = 0; power <= 2 * n - 3; ++power)
      EXPECT_NEAR(integrate(gaussLobatto(n, 0.0, 1.0), power), 1.0 / (power + 1), 1e-14)
          << n << " points, power " << power;
}

TEST(GaussLobatto, IsInexactBeyond) {
  for (int n = 2; n <= 6; ++n)
    EXPECT_GT(std::abs(integrate(gaussLobatto(n, 0.0, 1.0), 2 * n - 2) - 1.0 / (2 * n - 1)), 1e-8);
}

TEST(GaussLobatto, HasBothEndsAndPositiveWeights) {
  for (int n = 2; n <= 20; ++n) {
    const auto points = gaussLobatto(n, 2.0, 3.0);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(n));
    EXPECT_EQ(points.front().parameter, 2.0);
    EXPECT_EQ(points.back().parameter, 3.0);
    for (const auto& q : points) EXPECT_GT(q.weight, 0.0);
  }
}

TEST(QuadratureRule, IsTakenOnEverySpan) {
  const KnotVector knots = KnotVector::fromBreaks(3, {0.0, 0.3, 1.0});
  const auto lobatto = quadrature({4, QuadratureFamily::Lobatto}, knots);
  ASSERT_EQ(lobatto.size(), 8U);
  EXPECT_NEAR(lobatto[3].parameter, 0.3, 1e-15);
  EXPECT_LT(lobatto[3].parameter, 0.3);  // of the first span
  EXPECT_EQ(lobatto[4].parameter, 0.3);
  EXPECT_NEAR(integrate(lobatto, 5), 1.0 / 6.0, 1e-14);
  EXPECT_EQ(quadrature(4, knots).size(), 8U);
  EXPECT_GT(quadrature(4, knots).front().parameter, 0.0);
}

TEST(GaussLegendre, IsInexactBeyond) {
  for (int n = 1; n <= 5; ++n)
    EXPECT_GT(std::abs(integrate(gaussLegendre(n, 0.0, 1.0), 2 * n) - 1.0 / (2 * n + 1)), 1e-8);
}

TEST(GaussLegendre, HasPositiveWeightsAndInnerPoints) {
  for (int n = 1; n <= 20; ++n)
    for (const auto& q : gaussLegendre(n, 2.0, 3.0)) {
      EXPECT_GT(q.weight, 0.0);
      EXPECT_GT(q.parameter, 2.0);
      EXPECT_LT(q.parameter, 3.0);
    }
}

TEST(GaussLegendre, OnKnotsIsExactForPiecewisePolynomials) {
  // |t - 0.3| has a kink at the knot: exact span by span, and nowhere near exact otherwise.
  const KnotVector knots = KnotVector::fromBreaks(3, {0.0, 0.3, 1.0});
  double sum = 0.0;
  for (const auto& q : gaussLegendre(1, knots)) sum += q.weight * std::abs(q.parameter - 0.3);
  EXPECT_NEAR(sum, 0.5 * (0.09 + 0.49), 1e-15);
}

TEST(GaussLegendre, OnKnotsSkipsEmptySpans) {
  const KnotVector knots = KnotVector::fromBreaks(3, {0.0, 0.3, 1.0}, 3);
  EXPECT_EQ(gaussLegendre(4, knots).size(), 8U);
}

}  // namespace
}  // namespace fairing::spline
