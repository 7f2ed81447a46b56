// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/bezier_patch.h"

#include <gmock/gmock.h>

#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::spline {
namespace {

using ::fairing::testing::IsNear;
using ::fairing::testing::Random;
using ::fairing::testing::randomKnots;
using ::fairing::testing::randomSurface;

constexpr double kRounding = 1e-13;  // poles are of size 1

BsplineSurface someSurface() {
  Random random{3};
  const KnotVector u = randomKnots(random, 4, 3), v = randomKnots(random, 3, 2);
  return randomSurface(random, u, v);
}

TEST(BezierPatch, SpansAreTheSurfaceTheyComeFrom) {
  const BsplineSurface surface = someSurface();
  const std::vector<BezierSpan> spans = bezierSpans(surface);
  ASSERT_EQ(spans.size(), (surface.u.breaks().size() - 1) * (surface.v.breaks().size() - 1));
  for (const BezierSpan& span : spans)
    for (const double a : {0.0, 0.3, 1.0})
      for (const double b : {0.0, 0.7, 1.0})
        EXPECT_THAT(span.patch.evaluate(a, b),
                    IsNear(surface.evaluate(span.u0 + a * (span.u1 - span.u0),
                                            span.v0 + b * (span.v1 - span.v0)),
                           kRounding));
}

TEST(BezierPatch, OneSpanBsplineIsTheSamePatch) {
  const BezierPatch patch = bezierSpans(someSurface()).front().patch;
  const BsplineSurface surface = toBspline(patch);
  for (const double u : {0.0, 0.2, 0.9})
    for (const double v : {0.1, 0.5, 1.0})
      EXPECT_THAT(surface.evaluate(u, v), IsNear(patch.evaluate(u, v), kRounding));
}

TEST(BezierPatch, CornersAreItsOuterPoles) {
  const BezierPatch patch = bezierSpans(someSurface()).back().patch;
  EXPECT_THAT(patch.evaluate(0.0, 0.0), IsNear(patch.poles.row(0).transpose(), 0.0));
  EXPECT_THAT(patch.evaluate(1.0, 1.0),
              IsNear(patch.poles.row(patch.poles.rows() - 1).transpose(), 0.0));
}

}  // namespace
}  // namespace fairing::spline
