// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/arc_length.h"

#include <gmock/gmock.h>

#include <numbers>
#include <utility>

#include "support/many_sided_loops.h"
#include "support/random_splines.h"

namespace fairing::boundary {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

constexpr double kRadius = 3.0;

TEST(ArcLength, IsThatOfACircleRunThroughUnevenly) {
  const Sides sides = halfCirclesOn(plane(), kRadius);
  const ArcLength arc(sides[0].ribbon, 0.0, 1.0);
  EXPECT_NEAR(arc.length(), std::numbers::pi * kRadius, 1e-11);
  for (const double t : {0.0, 0.17, 0.5, 0.83, 1.0})
    EXPECT_NEAR(arc.lengthUpTo(t), std::numbers::pi * kRadius * (t + 0.3 * t * (1.0 - t)), 1e-10);
}

TEST(ArcLength, FindsTheParameterOfALength) {
  const Sides sides = halfCirclesOn(plane(), kRadius);
  for (const auto& [from, to] : {std::pair{0.0, 1.0}, std::pair{0.2, 0.7}}) {
    const ArcLength arc(sides[0].ribbon, from, to);
    for (const double share : {0.0, 0.1, 0.45, 0.9, 1.0}) {
      const double t = from + share * (to - from);
      EXPECT_NEAR(arc.parameterAt(arc.lengthUpTo(t)), t, 1e-10) << from << " to " << to;
    }
  }
}

TEST(ArcLength, OfASplineIsTheSumOfItsParts) {
  Random random{0};
  const auto knots = randomKnots(random, 3, 4);
  const Sides sides = borderOf(randomSurface(random, knots, knots, 0.1));
  const ArcLength whole(sides[0].ribbon, 0.1, 0.8);
  const ArcLength first(sides[0].ribbon, 0.1, 0.3), second(sides[0].ribbon, 0.3, 0.8);
  EXPECT_NEAR(first.length() + second.length(), whole.length(), 1e-10);
  EXPECT_NEAR(whole.lengthUpTo(0.3), first.length(), 1e-10);
}

}  // namespace
}  // namespace fairing::boundary
