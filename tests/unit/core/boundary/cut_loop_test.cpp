// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/cut_loop.h"

#include <gmock/gmock.h>

#include "support/many_sided_loops.h"
#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::boundary {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using Eigen::Vector3d;

constexpr int kManyPoles = 100;

BoundaryLoop splineBorder() {
  Random random{0};
  const auto u = randomKnots(random, 3, 3), v = randomKnots(random, 4, 2);
  return finished(borderOf(randomSurface(random, u, v, 0.05)));
}

const std::vector<LoopPlace> kFirstSideInThree{
    {0, 0.0}, {0, 0.3}, {0, 0.75}, {1, 0.0}, {2, 0.0}, {3, 0.0}};

// Two half circles cut in their middles: both new sides run over a joint.
CutLoop cutCircle() {
  const auto loop = finished(halfCirclesOn(waves(), 0.6));
  return cutLoop(loop, {{0, 0.5}, {1, 0.5}}, kManyPoles).value();
}

TEST(CutLoop, AStretchOfAPolynomialIsThatPolynomial) {
  const BoundaryLoop loop = splineBorder();
  const auto cut = cutLoop(loop, kFirstSideInThree, kManyPoles);
  ASSERT_TRUE(cut.has_value());
  ASSERT_EQ(cut->loop.sides.size(), 6U);
  const Ribbon& part = cut->loop.sides[1].ribbon;
  ASSERT_TRUE(part.polynomial.has_value());
  for (const double t : {0.0, 0.2, 0.6, 1.0}) {
    const CurveSample whole = loop.sides[0].ribbon.curve(0.3 + 0.45 * t);
    EXPECT_THAT(part.polynomial->evaluate(t), IsNear(whole.point, 1e-13));
    EXPECT_THAT(part.curve(t).point, IsNear(whole.point, 1e-14));
    EXPECT_THAT(part.curve(t).derivative, IsNear(Vector3d(0.45 * whole.derivative), 1e-12));
  }
}

TEST(CutLoop, APolynomialOfManyPolesRunsAtConstantSpeed) {
  const auto cut = cutLoop(splineBorder(), kFirstSideInThree, 2);
  ASSERT_TRUE(cut.has_value());
  for (const BoundarySide& side : cut->loop.sides) {
    EXPECT_FALSE(side.ribbon.polynomial.has_value());
    for (const double t : {0.0, 0.35, 0.8, 1.0})
      EXPECT_NEAR(side.ribbon.curve(t).derivative.norm(), side.length, 1e-9);
  }
}

TEST(CutLoop, AChainRunsAtConstantSpeed) {
  for (const BoundarySide& side : cutCircle().loop.sides)
    for (const double t : {0.0, 0.1, 0.4, 0.6, 0.95, 1.0})
      EXPECT_NEAR(side.ribbon.curve(t).derivative.norm(), side.length, 1e-7 * side.length);
}

TEST(CutLoop, AChainGoesSmoothlyOverItsJoint) {
  for (const BoundarySide& side : cutCircle().loop.sides) {
    ASSERT_EQ(side.ribbon.breaks.size(), 1U);
    const double joint = side.ribbon.breaks[0].t;
    constexpr double kStep = 1e-8;
    const CurveSample before = side.ribbon.curve(joint - kStep);
    const CurveSample after = side.ribbon.curve(joint + kStep);
    EXPECT_THAT(after.point, IsNear(before.point, 1e-7));
    EXPECT_THAT(after.derivative, IsNear(before.derivative, 1e-6));
    EXPECT_THAT(Vector3d(after.point - before.point),
                IsNear(Vector3d(2.0 * kStep * before.derivative), 1e-13));
  }
}

TEST(CutLoop, StretchesLeadBackToTheEdges) {
  const BoundaryLoop loop = finished(halfCirclesOn(waves(), 0.6));
  const CutLoop cut = cutLoop(loop, {{0, 0.5}, {1, 0.5}}, kManyPoles).value();
  ASSERT_EQ(cut.stretches.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    double end = 0.0;
    for (const Stretch& s : cut.stretches[k]) {
      EXPECT_NEAR(s.start, end, 1e-14);
      end = s.end;
      const auto& side = cut.loop.sides[k].ribbon;
      const auto& edge = loop.sides[s.edge].ribbon;
      EXPECT_THAT(side.curve(s.start).point, IsNear(edge.curve(s.from).point, 1e-9));
      EXPECT_THAT(side.curve(s.end).point, IsNear(edge.curve(s.to).point, 1e-9));
    }
    EXPECT_EQ(end, 1.0);
  }
}

TEST(CutLoop, AChainTakesTheStrictestContinuityAndKeepsEachOnesOwn) {
  Sides sides = halfCirclesOn(waves(), 0.6);
  sides[1].continuity = Continuity::G0;
  const CutLoop cut = cutLoop(finished(sides), {{0, 0.5}, {1, 0.5}}, kManyPoles).value();
  EXPECT_EQ(cut.loop.sides[0].continuity, Continuity::G1);
  EXPECT_EQ(cut.loop.sides[0].continuityAt(0.1), Continuity::G1);
  EXPECT_EQ(cut.loop.sides[0].continuityAt(0.9), Continuity::G0);
}

}  // namespace
}  // namespace fairing::boundary
