// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/side_curves.h"

#include <gmock/gmock.h>

#include "support/known_loops.h"
#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::layout {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using spline::KnotVector;

boundary::BoundarySide polynomialSide(const spline::BsplineCurve& curve) {
  boundary::BoundarySide side;
  side.ribbon.polynomial = curve;
  side.ribbon.curve = [curve](double t) {
    return boundary::CurveSample{curve.evaluate(t), curve.evaluate(t, 1)};
  };
  return side;
}

boundary::BoundarySide arc() {
  return sideOn(sphere(1.0), line({0.0, 0.0}, {1.5, 0.0}), 0);
}

TEST(SideCurves, APolynomialSideKeepsItsKnots) {
  Random random{0};
  const auto side = polynomialSide(randomCurve(random, randomKnots(random, 5, 3)));
  EXPECT_EQ(chooseKnots({{&side, false}}, 0, 1e-6, 100), side.ribbon.polynomial->knots);
}

TEST(SideCurves, ReversedSideIsSeenFromItsOtherEnd) {
  Random random{1};
  const auto side = polynomialSide(randomCurve(random, randomKnots(random, 5, 3)));
  const DirectedSide back{&side, true};
  const SideCurve curve = curveOnKnots(back, chooseKnots({back}, 0, 1e-6, 100));
  EXPECT_EQ(curve.deviation, 0.0);
  for (const double t : {0.0, 0.3, 0.8, 1.0})
    EXPECT_THAT(curve.curve.evaluate(t), IsNear(side.ribbon.curve(1.0 - t).point, 1e-13));
}

TEST(SideCurves, AnArcIsFittedWithinTheTolerance) {
  const auto side = arc();
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    const DirectedSide directed{&side, false};
    const SideCurve curve = curveOnKnots(directed, chooseKnots({directed}, 3, tolerance, 200));
    EXPECT_LE(curve.deviation, tolerance);
    // 1.2: the fit's own check points may miss the worst place by a little.
    for (int k = 0; k <= 100; ++k)
      EXPECT_LT((curve.curve.evaluate(k / 100.0) - side.ribbon.curve(k / 100.0).point).norm(),
                1.2 * tolerance);
  }
}

TEST(SideCurves, AFitThatMayNotGrowSaysHowFarItIsOff) {
  const auto side = arc();
  const DirectedSide directed{&side, false};
  const KnotVector knots = chooseKnots({directed}, 3, 1e-12, 8);
  EXPECT_LE(knots.poleCount(), 8);
  EXPECT_GT(curveOnKnots(directed, knots).deviation, 1e-12);
}

TEST(SideCurves, KnotsOfARoundingApartBecomeOne) {
  // The same CAD knot seen from either side of a hole.
  Random random{2};
  const auto a = polynomialSide(randomCurve(random, KnotVector::fromBreaks(5, {0.0, 0.3, 1.0})));
  const auto b =
      polynomialSide(randomCurve(random, KnotVector::fromBreaks(5, {0.0, 0.3 + 1e-9, 1.0})));
  const KnotVector knots = chooseKnots({{&a, false}, {&b, false}}, 0, 1e-6, 100);
  EXPECT_EQ(knots.breaks().size(), 3U);
  const SideCurve curve = curveOnKnots({&b, false}, knots);
  for (const double t : {0.1, 0.3, 0.7})
    EXPECT_THAT(curve.curve.evaluate(t), IsNear(b.ribbon.curve(t).point, 1e-7));
}

TEST(SideCurves, AManySpanCubicIsNotRaised) {
  Random random{3};
  const auto side = polynomialSide(randomCurve(random, randomKnots(random, 3, 20)));
  EXPECT_EQ(chooseKnots({{&side, false}}, 0, 1e-6, 1000).degree(), 3);
}

}  // namespace
}  // namespace fairing::layout
