// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/closest_point.h"

#include <gmock/gmock.h>

#include "support/known_surface.h"
#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::spline {
namespace {

using namespace ::fairing::testing;  // NOLINT: known surfaces and random splines
using spline::BsplineSurface;

BsplineSurface gentleSurface() {
  Random random{0};
  const auto u = randomKnots(random, 4, 3), v = randomKnots(random, 5, 2);
  return randomSurface(random, u, v, 0.02);
}

TEST(ClosestPoint, FindsTheFootOfAPointLiftedAlongTheNormal) {
  const BsplineSurface surface = gentleSurface();
  for (const double u : {0.1, 0.45, 0.8})
    for (const double v : {0.2, 0.7})
      for (const double height : {-1e-2, 1e-6, 1e-2}) {
        const spline::SurfaceJet jet = surface.jet(u, v);
        const SurfaceFoot foot =
            closestPoint(surface, jet.point + height * normalOf(jet), u + 0.03, v - 0.03);
        EXPECT_NEAR(foot.distance, std::abs(height), 1e-12);
        EXPECT_NEAR(foot.u, u, 1e-9);
        EXPECT_NEAR(foot.v, v, 1e-9);
      }
}

TEST(ClosestPoint, OfAPointOnTheSurfaceIsThePoint) {
  const BsplineSurface surface = gentleSurface();
  const SurfaceFoot foot = closestPoint(surface, surface.evaluate(0.31, 0.62), 0.3, 0.6);
  EXPECT_LT(foot.distance, 1e-14);
}

TEST(ClosestPoint, StaysInsideTheDomain) {
  const BsplineSurface surface =
      interpolated([](double u, double v) { return Eigen::Vector3d(u, v, 0.0); },
                   spline::KnotVector::bezier(3),
                   spline::KnotVector::bezier(3));
  const SurfaceFoot foot = closestPoint(surface, {1.3, 0.4, 0.0}, 0.9, 0.5);
  EXPECT_EQ(foot.u, 1.0);
  EXPECT_NEAR(foot.v, 0.4, 1e-9);
  EXPECT_NEAR(foot.distance, 0.3, 1e-12);
}

TEST(ClosestPoint, JetIsThatOfTheFoot) {
  const BsplineSurface surface = gentleSurface();
  const SurfaceFoot foot = closestPoint(surface, {0.4, 0.6, 0.05}, 0.5, 0.5);
  EXPECT_THAT(foot.jet.point, IsNear(surface.evaluate(foot.u, foot.v), 1e-14));
}

TEST(ClosestPoint, GivesAFiniteFootOnADegeneratePatch) {
  // One edge collapsed to a point.
  BsplineSurface surface = gentleSurface();
  for (int i = 0; i < surface.u.poleCount(); ++i)
    surface.poles.row(surface.index(i, 0)).setConstant(0.5);
  const SurfaceFoot foot = closestPoint(surface, {0.5, 0.5, 0.6}, 0.3, 0.0);
  EXPECT_TRUE(std::isfinite(foot.distance));
}

}  // namespace
}  // namespace fairing::spline
