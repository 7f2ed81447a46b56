// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/bspline_curve.h"

#include <gmock/gmock.h>

#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/random_splines.h"

namespace fairing::spline {
namespace {

using ::fairing::testing::evenParameters;
using ::fairing::testing::IsNear;
using ::fairing::testing::Random;
using ::fairing::testing::randomCurve;
using ::fairing::testing::randomKnots;

// Poles are of size 1: a few roundings per round of de Boor's triangle.
constexpr double kRounding = 1e-13;

void expectSameCurve(const BsplineCurve& a, const BsplineCurve& b, double tolerance = kRounding) {
  for (const double t : evenParameters(a.knots, 37))
    EXPECT_THAT(a.evaluate(t), IsNear(b.evaluate(t), tolerance)) << "at " << t;
}

TEST(BsplineCurve, StartsAndEndsAtItsOuterPoles) {
  Random random{0};
  const BsplineCurve curve = randomCurve(random, randomKnots(random, 4, 3, 4));
  EXPECT_THAT(curve.evaluate(0.0), IsNear(curve.poles.row(0).transpose(), 0.0));
  EXPECT_THAT(curve.evaluate(1.0),
              IsNear(curve.poles.row(curve.poles.rows() - 1).transpose(), 0.0));
}

TEST(BsplineCurve, DerivativesAreThoseOfThePosition) {
  Random random{1};
  const BsplineCurve curve = randomCurve(random, randomKnots(random, 5, 2));
  for (int order = 1; order <= 3; ++order) {
    const auto below = [&](double t) { return curve.evaluate(t, order - 1); };
    const Eigen::Vector3d exact = curve.evaluate(0.25, order);
    EXPECT_THAT(exact,
                IsNear(::fairing::testing::derivative(below, 0.25), 1e-8 * (1.0 + exact.norm())));
  }
}

TEST(BsplineCurve, ReversalMirrorsTheParameter) {
  Random random{2};
  const BsplineCurve curve = randomCurve(random, randomKnots(random, 3, 5, 2));
  const BsplineCurve back = reversed(curve);
  for (const double t : evenParameters(curve.knots, 23))
    EXPECT_THAT(back.evaluate(1.0 - t), IsNear(curve.evaluate(t), kRounding));
}

TEST(BsplineCurve, ReversedTwiceIsItself) {
  Random random{3};
  const BsplineCurve curve = randomCurve(random, randomKnots(random, 3, 4));
  EXPECT_EQ(reversed(reversed(curve)).poles, curve.poles);
}

TEST(BsplineCurve, KnotInsertionKeepsTheCurve) {
  Random random{4};
  for (int degree = 1; degree <= 7; ++degree) {
    const BsplineCurve curve = randomCurve(random, randomKnots(random, degree, 4));
    expectSameCurve(curve, insertKnot(curve, 0.37));
  }
}

TEST(BsplineCurve, InsertionAtAKnotKeepsTheCurve) {
  Random random{5};
  const BsplineCurve curve = randomCurve(random, randomKnots(random, 4, 3));
  const double knot = curve.knots.breaks()[1];
  const BsplineCurve finer = insertKnot(insertKnot(curve, knot), knot);
  EXPECT_EQ(finer.knots.multiplicities()[1], 3);
  expectSameCurve(curve, finer);
}

TEST(BsplineCurve, InsertionAddsOnePole) {
  Random random{6};
  const BsplineCurve curve = randomCurve(random, randomKnots(random, 4, 3));
  EXPECT_EQ(insertKnot(curve, 0.6).poles.rows(), curve.poles.rows() + 1);
}

TEST(BsplineCurve, RefinementToFinerKnotsKeepsTheCurve) {
  Random random{7};
  const BsplineCurve curve = randomCurve(random, randomKnots(random, 5, 4));
  const KnotVector finer = merged(curve.knots, randomKnots(random, 5, 6, 3));
  expectSameCurve(curve, refinedTo(curve, finer));
}

TEST(BsplineCurve, OrderOfInsertionIsIrrelevant) {
  Random random{8};
  const BsplineCurve curve = randomCurve(random, randomKnots(random, 4, 2));
  const BsplineCurve a = insertKnot(insertKnot(curve, 0.2), 0.7);
  const BsplineCurve b = insertKnot(insertKnot(curve, 0.7), 0.2);
  EXPECT_THAT(a.poles, IsNear(b.poles, kRounding));
}

TEST(BsplineCurve, DegreeRaisingKeepsTheCurve) {
  Random random{9};
  for (int degree = 1; degree <= 5; ++degree)
    for (int times = 1; times <= 3; ++times) {
      const BsplineCurve curve = randomCurve(random, randomKnots(random, degree, 3, degree));
      const BsplineCurve raised = raiseDegree(curve, times);
      EXPECT_EQ(raised.knots.degree(), degree + times);
      expectSameCurve(curve, raised);
    }
}

TEST(BsplineCurve, RaisedBezierFollowsTheClassicalFormula) {
  // Q_i = i/(p+1) P_{i-1} + (1 - i/(p+1)) P_i, [PieglTiller1997] eq. 5.34
  Random random{10};
  const BsplineCurve curve = randomCurve(random, KnotVector::bezier(3));
  const BsplineCurve raised = raiseDegree(curve, 1);
  for (int i = 1; i <= 3; ++i) {
    const double share = i / 4.0;
    EXPECT_THAT(
        raised.poles.row(i),
        IsNear(share * curve.poles.row(i - 1) + (1.0 - share) * curve.poles.row(i), kRounding));
  }
}

TEST(BsplineCurve, RaisingByNothingIsTheCurve) {
  Random random{11};
  const BsplineCurve curve = randomCurve(random, randomKnots(random, 3, 4));
  EXPECT_EQ(raiseDegree(curve, 0).poles, curve.poles);
}

}  // namespace
}  // namespace fairing::spline
