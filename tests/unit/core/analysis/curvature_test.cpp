// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/curvature.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "core/analysis/measure_fairness.h"
#include "support/known_surface.h"
#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/random_splines.h"

namespace fairing::analysis {
namespace {

using namespace ::fairing::testing;  // NOLINT: known surfaces and random splines
using spline::BsplineSurface;
using spline::KnotVector;

// A spline so close to a formula (degree 9, three spans of a third) that second derivatives are
// good to 1e-7.
BsplineSurface splineOf(const KnownSurface& surface) {
  const KnotVector knots = KnotVector::fromBreaks(9, {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0});
  return interpolated([&](double u, double v) { return surface(u, v).point; }, knots, knots);
}

constexpr double kClose = 1e-6;
constexpr double kU = 0.4, kV = 0.3;

TEST(Curvature, OfASphere) {
  const Curvature c = curvatureAt(splineOf(sphere(2.0)), kU, kV);
  EXPECT_NEAR(c.mean, -0.5, kClose);  // u x v points outwards
  EXPECT_NEAR(c.gauss, 0.25, kClose);
  EXPECT_NEAR(c.total(), 0.5, kClose);
  EXPECT_NEAR(c.largest(), 0.5, 1e-3);  // the square root of a difference of equals
  EXPECT_NEAR(c.meanGradientSquared, 0.0, kClose);
}

TEST(Curvature, OfACylinder) {
  const Curvature c = curvatureAt(splineOf(cylinder(2.0)), kU, kV);
  EXPECT_NEAR(c.mean, -0.25, kClose);
  EXPECT_NEAR(c.gauss, 0.0, kClose);
  EXPECT_NEAR(c.largest(), 0.5, kClose);
  EXPECT_NEAR(c.meanGradientSquared, 0.0, kClose);
  EXPECT_NEAR(c.areaElement, 2.0, kClose);
}

TEST(Curvature, OfATorus) {
  const double ring = 5.0, tube = 2.0;
  const auto meanAt = [&](double v) {
    return -0.5 * (1.0 / tube + std::cos(v) / (ring + tube * std::cos(v)));
  };
  const Curvature c = curvatureAt(splineOf(torus(ring, tube)), kU, kV);
  const double around = std::cos(kV) / (ring + tube * std::cos(kV));
  EXPECT_NEAR(c.mean, meanAt(kV), kClose);
  EXPECT_NEAR(c.gauss, around / tube, kClose);
  EXPECT_NEAR(c.meanGradientSquared, std::pow(derivative(meanAt, kV) / tube, 2), kClose);
}

TEST(Curvature, OfASaddle) {
  const Curvature c = curvatureAt(splineOf(saddle(0.7)), 0.0, 0.0);
  EXPECT_NEAR(c.mean, 0.0, 1e-10);  // a polynomial: reproduced to rounding
  EXPECT_NEAR(c.gauss, -4.0 * 0.7 * 0.7, 1e-9);
}

TEST(Curvature, GradientOfTheMeanIsThatOfItsDifferences) {
  Random random{0};
  const KnotVector knots = randomKnots(random, 5, 2);
  const BsplineSurface s = randomSurface(random, knots, knots);
  const double u = 0.21, v = 0.77;  // clear of the knots
  const Eigen::Vector2d slope(
      derivative([&](double x) { return curvatureAt(s, x, v).mean; }, u, 1e-4),
      derivative([&](double x) { return curvatureAt(s, u, x).mean; }, v, 1e-4));
  const spline::SurfaceJet r = s.jet(u, v);
  Eigen::Matrix2d metric;
  metric << r.u.dot(r.u), r.u.dot(r.v), r.u.dot(r.v), r.v.dot(r.v);
  const double expected = slope.dot(metric.inverse() * slope);
  EXPECT_NEAR(curvatureAt(s, u, v).meanGradientSquared, expected, 1e-6 * expected);
}

TEST(Curvature, DoesNotDependOnTheParametrisation) {
  Random random{1};
  const KnotVector knots = randomKnots(random, 5, 2);
  const BsplineSurface s = randomSurface(random, knots, knots);
  BsplineSurface stretched = s;
  stretched.u = s.u.mapped(0.0, 3.0);
  const Curvature a = curvatureAt(s, 0.3, 0.6), b = curvatureAt(stretched, 0.9, 0.6);
  EXPECT_NEAR(a.mean, b.mean, 1e-9 * std::abs(a.mean));
  EXPECT_NEAR(a.gauss, b.gauss, 1e-9 * std::abs(a.gauss));
  EXPECT_NEAR(a.meanGradientSquared, b.meanGradientSquared, 1e-9 * a.meanGradientSquared);
}

TEST(Curvature, PrincipalOnesAreThoseOfATorus) {
  const double ring = 5.0, tube = 2.0;
  const Curvature c = curvatureAt(splineOf(torus(ring, tube)), kU, kV);
  EXPECT_NEAR(c.k1(), -std::cos(kV) / (ring + tube * std::cos(kV)), kClose);
  EXPECT_NEAR(c.k2(), -1.0 / tube, kClose);
}

TEST(NormalCurvature, AlongAndAcrossACylinder) {
  const spline::SurfaceJet jet = splineOf(cylinder(2.0)).jet(kU, kV);
  EXPECT_NEAR(normalCurvature(jet, jet.u), -0.5, kClose);
  EXPECT_NEAR(normalCurvature(jet, jet.v), 0.0, kClose);
  // Euler: half way between, half of it. Unit vectors along both.
  EXPECT_NEAR(normalCurvature(jet, jet.u.normalized() + jet.v.normalized()), -0.25, kClose);
}

TEST(NormalCurvature, IgnoresLengthAndNormalPartOfTheDirection) {
  const spline::SurfaceJet jet = splineOf(torus(5.0, 2.0)).jet(kU, kV);
  const Eigen::Vector3d d = jet.u - 2.0 * jet.v;
  EXPECT_NEAR(
      normalCurvature(jet, 7.0 * d + 0.3 * jet.normalVector()), normalCurvature(jet, d), 1e-10);
}

TEST(Fairness, OfASpherePatch) {
  // One unit of longitude from the equator to latitude 1.
  const FairnessReport report = measureFairness({splineOf(sphere(2.0))}, 4.0);
  const double area = 4.0 * std::sin(1.0);
  EXPECT_NEAR(report.area, area, 1e-3 * area);
  EXPECT_NEAR(report.totalCurvature, 0.5 * area, 1e-3 * area);
  EXPECT_NEAR(report.meanCurvatureGradient, 0.0, 1e-6);
  EXPECT_NEAR(report.largestCurvature, 0.5, 1e-3);
}

TEST(Fairness, AddsUpOverPatches) {
  const BsplineSurface patch = splineOf(torus(5.0, 2.0));
  const FairnessReport one = measureFairness({patch}, 10.0),
                       two = measureFairness({patch, patch}, 10.0);
  EXPECT_NEAR(two.area, 2.0 * one.area, 1e-12 * one.area);
  EXPECT_NEAR(two.totalCurvature, 2.0 * one.totalCurvature, 1e-12);
  EXPECT_NEAR(two.thinPlate, 2.0 * one.thinPlate, 1e-12 * two.thinPlate);
  EXPECT_NEAR(two.minimumVariation, 2.0 * one.minimumVariation, 1e-12);
  EXPECT_EQ(two.largestCurvature, one.largestCurvature);
}

TEST(Fairness, OfASaddleIsThatOfEveryEnergy) {
  // z = c (x^2 - y^2) over the unit square: R_uu = -R_vv = (0, 0, 2 c).
  const double steepness = 0.7;
  const BsplineSurface patch = splineOf(saddle(steepness));
  const FairnessReport report = measureFairness({patch}, std::sqrt(2.0));
  EXPECT_NEAR(report.thinPlate, 8.0 * steepness * steepness, 1e-8);
  const shape_energy::MinimumVariation energy(shape_energy::kUmbilicShare / std::sqrt(2.0));
  double sum = 0.0;  // by midpoints
  const int cells = 200;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      sum += energy
                 .residuals(spline::thirdOrderJet(
                     patch.derivatives((i + 0.5) / cells, (j + 0.5) / cells, 3)))
                 .squaredNorm();
  sum /= cells * cells;
  EXPECT_NEAR(report.minimumVariation, sum, 1e-3 * sum);
  EXPECT_GT(report.minimumVariation, 0.1);
}

TEST(Fairness, KnowsTheSurfacesWithoutVariation) {
  EXPECT_NEAR(measureFairness({splineOf(torus(5.0, 2.0))}, 5.0).minimumVariation, 0.0, 1e-6);
  EXPECT_NEAR(measureFairness({splineOf(sphere(2.0))}, 2.0).minimumVariation, 0.0, 1e-6);
}

}  // namespace
}  // namespace fairing::analysis
