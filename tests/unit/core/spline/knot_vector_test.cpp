// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/knot_vector.h"

#include <gmock/gmock.h>

namespace fairing::spline {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

const KnotVector kUneven{3, {0, 0, 0, 0, 0.2, 0.5, 0.5, 1, 1, 1, 1}};

TEST(KnotVector, CountsPolesByKnotsAndDegree) {
  EXPECT_EQ(kUneven.poleCount(), 7);
  EXPECT_EQ(KnotVector::bezier(5).poleCount(), 6);
}

TEST(KnotVector, BreaksAreTheDistinctKnots) {
  EXPECT_THAT(kUneven.breaks(), ElementsAre(0.0, 0.2, 0.5, 1.0));
  EXPECT_THAT(kUneven.multiplicities(), ElementsAre(4, 1, 2, 4));
}

TEST(KnotVector, SpanIsHalfOpenButForTheLast) {
  EXPECT_EQ(kUneven.span(0.0), 3);
  EXPECT_EQ(kUneven.span(0.2), 4);
  EXPECT_EQ(kUneven.span(0.5), 6);
  EXPECT_EQ(kUneven.span(1.0), 6);
}

TEST(KnotVector, GrevilleAbscissaeAreMeansOfInnerKnots) {
  EXPECT_THAT(
      kUneven.grevilleAbscissae(),
      Pointwise(DoubleNear(1e-15), {0.0, 0.2 / 3, 0.7 / 3, 1.2 / 3, 2.0 / 3, 2.5 / 3, 1.0}));
}

TEST(KnotVector, ReversedTwiceIsItself) {
  // 0.2, 0.5 and 1 - (1 - x) are exact enough: one rounding of numbers below 1.
  EXPECT_THAT(kUneven.reversed().reversed().knots(), Pointwise(DoubleNear(1e-15), kUneven.knots()));
  EXPECT_THAT(kUneven.reversed().multiplicities(), ElementsAre(4, 2, 1, 4));
}

TEST(KnotVector, ReversalKeepsADomainThatDoesNotStartAtZero) {
  const KnotVector knots = KnotVector::fromBreaks(2, {3.0, 4.0, 7.0});
  EXPECT_THAT(knots.reversed().breaks(), ElementsAre(3.0, 6.0, 7.0));
}

TEST(KnotVector, MappedMovesEveryKnotAffinely) {
  const KnotVector knots = kUneven.mapped(2.0, 4.0);
  EXPECT_THAT(knots.breaks(), Pointwise(DoubleNear(1e-15), {2.0, 2.4, 3.0, 4.0}));
  EXPECT_EQ(knots.multiplicities(), kUneven.multiplicities());
}

TEST(KnotVector, WithKnotAddsOne) {
  EXPECT_THAT(kUneven.withKnot(0.5).multiplicities(), ElementsAre(4, 1, 3, 4));
  EXPECT_THAT(kUneven.withKnot(0.7).breaks(), ElementsAre(0.0, 0.2, 0.5, 0.7, 1.0));
}

TEST(KnotVector, RaisingKeepsTheContinuityAtEveryBreak) {
  const KnotVector raised = kUneven.raised(2);
  EXPECT_EQ(raised.degree(), 5);
  EXPECT_THAT(raised.multiplicities(), ElementsAre(6, 3, 4, 6));
}

TEST(KnotVector, MergedHasTheLargerMultiplicityOfEachBreak) {
  const KnotVector other{3, {0, 0, 0, 0, 0.2, 0.2, 0.8, 1, 1, 1, 1}};
  const KnotVector both = merged(kUneven, other);
  EXPECT_THAT(both.breaks(), ElementsAre(0.0, 0.2, 0.5, 0.8, 1.0));
  EXPECT_THAT(both.multiplicities(), ElementsAre(4, 2, 2, 1, 4));
  EXPECT_EQ(merged(other, kUneven), both);
}

TEST(KnotVector, MergedTakesKnotsARoundingApartForOne) {
  const KnotVector other{3, {0, 0, 0, 0, 0.2 + 1e-12, 1, 1, 1, 1}};
  EXPECT_EQ(merged(kUneven, other), kUneven);
}

TEST(KnotVector, MergedGivesCopiesOfAKnotARoundingApartOneValue) {
  const KnotVector two{3, {0, 0, 0, 0, 0.2, 0.2, 1, 1, 1, 1}};
  for (const double at : {0.2 + 1e-12, 0.2 - 1e-12}) {
    const KnotVector three{3, {0, 0, 0, 0, at, at, at, 1, 1, 1, 1}};
    for (const KnotVector& both : {merged(two, three), merged(three, two)}) {
      EXPECT_EQ(both.breaks().size(), 3u);
      EXPECT_THAT(both.multiplicities(), ElementsAre(4, 3, 4));
    }
  }
}

TEST(KnotVector, MergedWithItselfIsItself) {
  EXPECT_EQ(merged(kUneven, kUneven), kUneven);
}

}  // namespace
}  // namespace fairing::spline
