// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/bspline_surface.h"

#include <gmock/gmock.h>

#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/random_splines.h"

namespace fairing::spline {
namespace {

using ::fairing::testing::evenParameters;
using ::fairing::testing::IsNear;
using ::fairing::testing::Random;
using ::fairing::testing::randomKnots;
using ::fairing::testing::randomSurface;

constexpr double kRounding = 1e-13;  // poles are of size 1

BsplineSurface someSurface(unsigned seed) {
  Random random{seed};
  const KnotVector u = randomKnots(random, 4, 3), v = randomKnots(random, 3, 2);
  return randomSurface(random, u, v);
}

void expectSameSurface(const BsplineSurface& a, const BsplineSurface& b) {
  for (const double s : evenParameters(a.u, 9))
    for (const double t : evenParameters(a.v, 9))
      EXPECT_THAT(a.evaluate(s, t), IsNear(b.evaluate(s, t), kRounding));
}

TEST(BsplineSurface, CornersAreItsOuterPoles) {
  const BsplineSurface s = someSurface(0);
  const int i = s.u.poleCount() - 1, j = s.v.poleCount() - 1;
  EXPECT_THAT(s.evaluate(0.0, 0.0), IsNear(s.pole(0, 0), 0.0));
  EXPECT_THAT(s.evaluate(1.0, 0.0), IsNear(s.pole(i, 0), 0.0));
  EXPECT_THAT(s.evaluate(0.0, 1.0), IsNear(s.pole(0, j), 0.0));
  EXPECT_THAT(s.evaluate(1.0, 1.0), IsNear(s.pole(i, j), 0.0));
}

TEST(BsplineSurface, BordersAreTheCurvesOfItsOuterPoles) {
  const BsplineSurface s = someSurface(1);
  BsplineCurve south{s.u, Poles(s.u.poleCount(), 3)}, east{s.v, Poles(s.v.poleCount(), 3)};
  for (int i = 0; i < s.u.poleCount(); ++i) south.poles.row(i) = s.pole(i, 0).transpose();
  for (int j = 0; j < s.v.poleCount(); ++j)
    east.poles.row(j) = s.pole(s.u.poleCount() - 1, j).transpose();
  for (const double t : evenParameters(s.u, 11)) {
    EXPECT_THAT(s.evaluate(t, 0.0), IsNear(south.evaluate(t), kRounding));
    EXPECT_THAT(s.evaluate(1.0, t), IsNear(east.evaluate(t), kRounding));
  }
}

TEST(BsplineSurface, PartialDerivativesAreThoseOfThePosition) {
  const BsplineSurface s = someSurface(2);
  const double u = 0.52, v = 0.23;
  for (int a = 0; a <= 3; ++a)
    for (int b = 0; a + b <= 3; ++b) {
      if (a + b == 0) continue;
      const auto below = [&](double x) {
        return a > 0 ? s.evaluate(x, v, a - 1, b) : s.evaluate(u, x, a, b - 1);
      };
      const Eigen::Vector3d exact = s.evaluate(u, v, a, b);
      EXPECT_THAT(
          exact,
          IsNear(::fairing::testing::derivative(below, a > 0 ? u : v), 1e-8 * (1.0 + exact.norm())))
          << a << ", " << b;
    }
}

TEST(BsplineSurface, JetHoldsWhatEvaluateGives) {
  const BsplineSurface s = someSurface(3);
  const SurfaceJet jet = s.jet(0.4, 0.7);
  EXPECT_THAT(jet.point, IsNear(s.evaluate(0.4, 0.7), kRounding));
  EXPECT_THAT(jet.u, IsNear(s.evaluate(0.4, 0.7, 1, 0), kRounding));
  EXPECT_THAT(jet.v, IsNear(s.evaluate(0.4, 0.7, 0, 1), kRounding));
  EXPECT_THAT(jet.uu, IsNear(s.evaluate(0.4, 0.7, 2, 0), 1e2 * kRounding));
  EXPECT_THAT(jet.uv, IsNear(s.evaluate(0.4, 0.7, 1, 1), 1e2 * kRounding));
  EXPECT_THAT(jet.vv, IsNear(s.evaluate(0.4, 0.7, 0, 2), 1e2 * kRounding));
}

TEST(BsplineSurface, DerivativesAreLaidOutByOrders) {
  const BsplineSurface s = someSurface(4);
  const Eigen::Matrix3Xd all = s.derivatives(0.3, 0.8, 3);
  for (int a = 0; a <= 3; ++a)
    for (int b = 0; b <= 3; ++b)
      // Derivatives reach 1e4.
      EXPECT_THAT(Eigen::Vector3d(all.col(4 * a + b)),
                  IsNear(s.evaluate(0.3, 0.8, a, b), 1e4 * kRounding));
}

TEST(BsplineSurface, TransposingSwapsTheParameters) {
  const BsplineSurface s = someSurface(5), swapped = transposed(s);
  EXPECT_THAT(swapped.evaluate(0.2, 0.6), IsNear(s.evaluate(0.6, 0.2), kRounding));
  EXPECT_EQ(transposed(swapped).poles, s.poles);
}

TEST(BsplineSurface, TransposingTurnsTheNormal) {
  const BsplineSurface s = someSurface(6);
  EXPECT_THAT(transposed(s).jet(0.2, 0.6).normalVector(),
              IsNear(-s.jet(0.6, 0.2).normalVector(), 1e-12));
}

TEST(BsplineSurface, KnotInsertionKeepsTheSurface) {
  const BsplineSurface s = someSurface(7);
  expectSameSurface(s, refinedTo(s, s.u.withKnot(0.3).withKnot(0.3), s.v.withKnot(0.9)));
}

TEST(BsplineSurface, DegreeRaisingKeepsTheSurface) {
  const BsplineSurface s = someSurface(8), raised = raiseDegree(s, 1, 3);
  EXPECT_EQ(raised.u.degree(), 5);
  EXPECT_EQ(raised.v.degree(), 6);
  expectSameSurface(s, raised);
}

}  // namespace
}  // namespace fairing::spline
