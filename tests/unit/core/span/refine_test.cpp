// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/refine.h"

#include <gmock/gmock.h>

#include "core/layout/build_layout.h"
#include "support/known_loops.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using ::testing::DoubleNear;
using ::testing::Pointwise;

const layout::LayoutPlan& square() {
  static const auto plan = *layout::planLayout(loopOf(plane(), unitSquare()), LayoutKind::Quad);
  return plan;
}

layout::PatchLayout quadWith(const std::vector<double>& breaks) {
  const auto knots = spline::KnotVector::fromBreaks(5, breaks);
  return layout::buildLayout(square(), {knots, knots});
}

analysis::FillReport reportWith(std::size_t side, std::vector<analysis::AnglePlace> places) {
  analysis::FillReport report;
  report.angleLimit = 0.02;
  report.cornerAngleLimit = 0.05;
  report.gapLimit = 1e-6;
  report.sides.resize(4);
  for (analysis::SideReport& s : report.sides) s.cornerAngleLimit = report.cornerAngleLimit;
  report.sides[side].angleCurve = std::move(places);
  return report;
}

TEST(SideTraces, RunRoundTheDomainHeadToTail) {
  const auto traces = sideTraces(square(), quadWith({0.0, 1.0}));
  ASSERT_EQ(traces.size(), 4U);
  EXPECT_EQ(traces[0].start, Eigen::Vector2d(0.0, 0.0));
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(traces[k].side, static_cast<int>(k));
    EXPECT_EQ(traces[k].end, traces[(k + 1) % 4].start);
  }
}

TEST(WishedKnots, HalveTheSpanThatIsOver) {
  const auto wishes = wishedKnots(
      square(), quadWith({0.0, 0.5, 1.0}), reportWith(0, {{0.7, 0.1, 0.0, false}}), 1.0);
  EXPECT_THAT(wishes[0].u, Pointwise(DoubleNear(1e-12), {0.75}));
  EXPECT_TRUE(wishes[0].v.empty());
}

TEST(WishedKnots, OfTheNorthSideAreMirrored) {
  const auto wishes = wishedKnots(
      square(), quadWith({0.0, 0.5, 1.0}), reportWith(2, {{0.7, 0.1, 0.0, false}}), 1.0);
  EXPECT_THAT(wishes[0].u, Pointwise(DoubleNear(1e-12), {0.25}));
}

TEST(WishedKnots, OfEastAndWestLieAlongV) {
  const auto east = wishedKnots(
      square(), quadWith({0.0, 0.5, 1.0}), reportWith(1, {{0.7, 0.1, 0.0, false}}), 1.0);
  EXPECT_TRUE(east[0].u.empty());
  EXPECT_THAT(east[0].v, Pointwise(DoubleNear(1e-12), {0.75}));
}

TEST(WishedKnots, AreNoneWithinTheLimits) {
  EXPECT_TRUE(nothingWished(
      wishedKnots(square(), quadWith({0.0, 1.0}), reportWith(0, {{0.7, 0.01, 0.0, false}}), 1.0)));
}

TEST(WishedKnots, CornersHaveTheirOwnLimit) {
  const auto layout = quadWith({0.0, 1.0});
  EXPECT_TRUE(
      nothingWished(wishedKnots(square(), layout, reportWith(0, {{0.01, 0.04, 0.0, true}}), 1.0)));
  EXPECT_FALSE(
      nothingWished(wishedKnots(square(), layout, reportWith(0, {{0.01, 0.06, 0.0, true}}), 1.0)));
}

TEST(WishedKnots, ACornerThatStaysOverGradesTheKnotsTowardsIt) {
  // Ratio 1/2: breaks at 1/2, 1/4, 1/8.
  std::vector<double> breaks = {0.0, 1.0};
  for (const double expected : {0.5, 0.25, 0.125}) {
    const auto wishes =
        wishedKnots(square(), quadWith(breaks), reportWith(0, {{0.01, 1.0, 0.0, true}}), 1.0);
    ASSERT_EQ(wishes[0].u.size(), 1U);
    EXPECT_NEAR(wishes[0].u[0], expected, 1e-12);
    breaks.insert(breaks.begin() + 1, expected);
  }
}

TEST(WishedKnots, WhatIsTheEdgesOwnFaultIsLeft) {
  EXPECT_TRUE(nothingWished(
      wishedKnots(square(), quadWith({0.0, 1.0}), reportWith(0, {{0.7, 0.5, 0.5, false}}), 1.0)));
}

TEST(WishedKnots, G0SidesWishNothing) {
  auto report = reportWith(0, {{0.7, 5.0, 0.0, false}});
  report.sides[0].asked = Continuity::G0;
  EXPECT_TRUE(nothingWished(wishedKnots(square(), quadWith({0.0, 1.0}), report, 1.0)));
}

FillResult resultWithAngle(double angle) {
  FillResult result;
  result.report = reportWith(0, {});
  result.report.sides[0].angle.max = angle;
  return result;
}

double angleOf(const FillResult& result) {
  return result.report.sides[0].angle.max;
}

TEST(Better, KeepsTheOneThatIsLessOver) {
  EXPECT_EQ(angleOf(better(resultWithAngle(0.1), resultWithAngle(0.3))), 0.1);
  EXPECT_EQ(angleOf(better(resultWithAngle(0.3), resultWithAngle(0.1))), 0.1);
}

TEST(Better, AGoodAngleDoesNotExcuseACusp) {
  FillResult cusp = resultWithAngle(0.001);
  cusp.report.sides[0].backwards = true;
  EXPECT_EQ(angleOf(better(cusp, resultWithAngle(0.3))), 0.3);
}

}  // namespace
}  // namespace fairing
