// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/shape_energy/mean_curvature_gradient.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "core/analysis/curvature.h"
#include "support/known_jets.h"
#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/random_splines.h"

namespace fairing::shape_energy {
namespace {

using namespace ::fairing::testing;  // NOLINT: jets, random splines, derivatives

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

TEST(MeanCurvatureGradient, ValuesOfBothEntriesAgree) {
  Random random{3};
  const Jet jet = randomJet(random);
  EXPECT_EQ(kEnergy.residuals(jet), kEnergy.linearised(jet).values);
}

TEST(MeanCurvatureGradient, DerivativesAreThoseOfDifferences) {
  Random random{4};
  for (int times = 0; times < 20; ++times) {
    const Jet jet = randomJet(random);
    const ResidualsWithDerivatives exact = kEnergy.linearised(jet);
    ASSERT_EQ(exact.derivatives.rows(), 2);
    for (Eigen::Index k = 0; k < 27; ++k) {
      Jet unit = Jet::Zero();
      unit.data()[k] = 1.0;
      const Residuals numerical =
          derivative([&](double x) { return kEnergy.residuals(jet + x * unit); }, 0.0, 1e-4);
      EXPECT_THAT(exact.derivatives.col(k),
                  IsNear(numerical, 1e-8 * exact.derivatives.cwiseAbs().maxCoeff()));
    }
  }
}

TEST(MeanCurvatureGradient, DerivativesOnASphereAreThoseOfDifferences) {
  const Jet jet = revolvedJet(sphereProfile(1.0), 0.4, 0.5);
  Random random{5};
  const Jet direction = randomMatrix(random, 3, 9);
  const Residuals exact =
      kEnergy.linearised(jet).derivatives * Eigen::Map<const Eigen::VectorXd>(direction.data(), 27);
  const Residuals numerical =
      derivative([&](double x) { return kEnergy.residuals(jet + x * direction); }, 0.0, 1e-4);
  EXPECT_THAT(exact, IsNear(numerical, 1e-9));
}

TEST(MeanCurvatureGradient, MovesWithRigidMotions) {
  Random random{6};
  const Jet jet = randomJet(random);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.3, randomVector(random).normalized()).toRotationMatrix();
  EXPECT_THAT(kEnergy.residuals(turn * jet), IsNear(kEnergy.residuals(jet), 1e-12));
}

TEST(MeanCurvatureGradient, FallsWithTheSquareOfTheSize) {
  Random random{7};
  const Jet jet = randomJet(random);
  EXPECT_NEAR(density(10.0 * jet), density(jet) / 100.0, 1e-12 * density(jet));
}

TEST(MeanCurvatureGradient, DoesNotDependOnTheParameters) {
  Random random{8};
  for (int times = 0; times < 20; ++times) {
    const Jet jet = randomJet(random);
    const Eigen::Matrix2d change = randomMatrix(random, 2, 2);
    const double expected = density(jet) * std::abs(change.determinant());
    EXPECT_NEAR(density(reparametrised(jet, change)), expected, 1e-9 * expected);
  }
}

TEST(MeanCurvatureGradient, PrefersNeitherParameter) {
  Random random{9};
  const Jet jet = randomJet(random);
  Eigen::Matrix2d swap;
  swap << 0.0, 1.0, 1.0, 0.0;
  // The normal turns round, so H and both residuals change their signs.
  const Residuals expected = -kEnergy.residuals(jet).reverse();
  EXPECT_THAT(kEnergy.residuals(reparametrised(jet, swap)), IsNear(expected, 1e-12));
}

}  // namespace
}  // namespace fairing::shape_energy
