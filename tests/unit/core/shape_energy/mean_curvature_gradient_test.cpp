// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/shape_energy/mean_curvature_gradient.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/analysis/curvature.h"
#include "support/known_jets.h"
#include "support/matchers.h"
#include "support/random_splines.h"
#include "support/shape_energy_laws.h"

namespace fairing::shape_energy {
namespace {

using namespace ::fairing::testing;  // NOLINT: jets, random splines, laws

const MeanCurvatureGradient kEnergy;

double density(const Jet& jet) {
  return kEnergy.residuals(jet).squaredNorm();
}

Jet planeJet() {
  Random random{2};
  Jet jet = randomJet(random);
  jet.row(2).setZero();
  return jet;
}

void expectNone(const Jet& jet) {
  EXPECT_LT(kEnergy.residuals(jet).norm(), 1e-14);
  EXPECT_TRUE(kEnergy.linearised(jet).derivatives.allFinite());
}

TEST(MeanCurvatureGradient, VanishesOnPlanesWhateverTheirParameters) {
  expectNone(planeJet());
}

TEST(MeanCurvatureGradient, VanishesOnSpheresThoughEveryPointIsAnUmbilic) {
  for (const double v : {-1.2, 0.0, 0.7}) expectNone(revolvedJet(sphereProfile(2.0), 0.4, v));
}

TEST(MeanCurvatureGradient, VanishesOnCylinders) {
  expectNone(revolvedJet(cylinderProfile(2.0), 0.4, 0.3));
}

TEST(MeanCurvatureGradient, OfATorus) {
  const double ring = 5.0, tube = 2.0, v = 0.3;
  // H = -(1 / tube + cos v / (ring + tube cos v)) / 2; W = tube (ring + tube cos v).
  const double around = ring + tube * std::cos(v);
  const double slope = 0.5 * ring * std::sin(v) / (around * around);
  EXPECT_NEAR(density(revolvedJet(torusProfile(ring, tube), 0.4, v)),
              slope * slope / (tube * tube) * tube * around,
              1e-14);
}

TEST(MeanCurvatureGradient, IsWhatTheAnalysisMeasures) {
  Random random{0};
  const spline::KnotVector knots = randomKnots(random, 5, 2);
  const spline::BsplineSurface s = randomSurface(random, knots, knots);
  for (const double u : {0.1, 0.45, 0.9}) {
    const analysis::Curvature c = analysis::curvatureAt(s, u, 0.3);
    const double expected = c.meanGradientSquared * c.areaElement;
    EXPECT_NEAR(
        density(spline::thirdOrderJet(s.derivatives(u, 0.3, 3))), expected, 1e-10 * expected);
  }
}

TEST(MeanCurvatureGradient, DerivativesAreThoseOfDifferences) {
  expectExactDerivatives(kEnergy, 2);
}

TEST(MeanCurvatureGradient, DerivativesOnASphereAreThoseOfDifferences) {
  expectExactDerivativesAt(kEnergy, revolvedJet(sphereProfile(1.0), 0.4, 0.5));
}

TEST(MeanCurvatureGradient, MovesWithRigidMotions) {
  expectRigidInvariance(kEnergy);
}

TEST(MeanCurvatureGradient, FallsWithTheSquareOfTheSize) {
  expectScaling(kEnergy);
}

TEST(MeanCurvatureGradient, DoesNotDependOnTheParameters) {
  expectParameterInvariance(kEnergy);
}

TEST(MeanCurvatureGradient, PrefersNeitherParameter) {
  Random random{9};
  const Jet jet = randomJet(random);
  Eigen::Matrix2d swap;
  swap << 0.0, 1.0, 1.0, 0.0;
  // The normal turns round, so H and both residuals change their signs.
  const Residuals expected = -kEnergy.residuals(jet).reverse();
  EXPECT_THAT(kEnergy.residuals(reparametrised(jet, swap)),
              IsNear(expected, 1e-12 * expected.norm()));
}

}  // namespace
}  // namespace fairing::shape_energy
