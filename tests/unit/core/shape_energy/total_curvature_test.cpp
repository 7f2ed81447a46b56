// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/shape_energy/total_curvature.h"

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

const TotalCurvature kEnergy;

double density(const Jet& jet) {
  return kEnergy.residuals(jet).squaredNorm();
}

TEST(TotalCurvature, VanishesOnPlanesWhateverTheirParameters) {
  Random random{2};
  Jet jet = randomJet(random);
  jet.row(2).setZero();
  EXPECT_LT(kEnergy.residuals(jet).norm(), 1e-14);
  EXPECT_TRUE(kEnergy.linearised(jet).derivatives.allFinite());
}

TEST(TotalCurvature, OfASphere) {
  // Both curvatures 1/2; W = 4 cos v.
  EXPECT_NEAR(density(revolvedJet(sphereProfile(2.0), 0.4, 0.7)), 2.0 * std::cos(0.7), 1e-14);
}

TEST(TotalCurvature, OfACylinder) {
  EXPECT_NEAR(density(revolvedJet(cylinderProfile(2.0), 0.4, 0.3)), 0.25 * 2.0, 1e-14);
}

TEST(TotalCurvature, OfATorus) {
  const double ring = 5.0, tube = 2.0, v = 0.3;
  const double around = ring + tube * std::cos(v);
  EXPECT_NEAR(density(revolvedJet(torusProfile(ring, tube), 0.4, v)),
              (1.0 / (tube * tube) + std::pow(std::cos(v) / around, 2)) * tube * around,
              1e-14);
}

TEST(TotalCurvature, IsWhatTheAnalysisMeasures) {
  Random random{0};
  const spline::KnotVector knots = randomKnots(random, 5, 2);
  const spline::BsplineSurface s = randomSurface(random, knots, knots);
  for (const double u : {0.1, 0.45, 0.9}) {
    const analysis::Curvature c = analysis::curvatureAt(s, u, 0.3);
    const double expected = c.total() * c.areaElement;
    EXPECT_NEAR(
        density(spline::thirdOrderJet(s.derivatives(u, 0.3, 3))), expected, 1e-10 * expected);
  }
}

TEST(TotalCurvature, DerivativesAreThoseOfDifferences) {
  expectExactDerivatives(kEnergy, 3);
}

TEST(TotalCurvature, DerivativesOnASphereAreThoseOfDifferences) {
  expectExactDerivativesAt(kEnergy, revolvedJet(sphereProfile(1.0), 0.4, 0.5));
}

TEST(TotalCurvature, MovesWithRigidMotions) {
  expectRigidInvariance(kEnergy);
}

TEST(TotalCurvature, IsTheSameAtEverySize) {
  expectScaling(kEnergy);
}

TEST(TotalCurvature, DoesNotDependOnTheParameters) {
  expectParameterInvariance(kEnergy);
}

TEST(TotalCurvature, PrefersNeitherParameter) {
  Random random{9};
  const Jet jet = randomJet(random);
  Eigen::Matrix2d swap;
  swap << 0.0, 1.0, 1.0, 0.0;
  // The normal turns round, so the shape operator changes its sign.
  const Residuals expected = -kEnergy.residuals(jet).reverse();
  EXPECT_THAT(kEnergy.residuals(reparametrised(jet, swap)),
              IsNear(expected, 1e-12 * expected.norm()));
}

}  // namespace
}  // namespace fairing::shape_energy
