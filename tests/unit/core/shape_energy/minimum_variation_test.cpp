// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/shape_energy/minimum_variation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/known_jets.h"
#include "support/matchers.h"
#include "support/random_splines.h"
#include "support/shape_energy_laws.h"

namespace fairing::shape_energy {
namespace {

using namespace ::fairing::testing;  // NOLINT: jets, random splines, laws

const MinimumVariation kEnergy(1e-13);  // what it leaves of a cone is the square of that

double density(const Jet& jet) {
  return kEnergy.residuals(jet).squaredNorm();
}

// A cone of half the opening angle 45 degrees.
Profile coneProfile() {
  return [](double v, int order) -> Eigen::Vector2d {
    if (order == 0) return {v, v};
    return order == 1 ? Eigen::Vector2d(1.0, 1.0) : Eigen::Vector2d(0.0, 0.0);
  };
}

// An ellipse with half axes 3 and 2 beside the axis, swept: no cyclide.
Profile ellipseProfile() {
  return [](double v, int order) -> Eigen::Vector2d {
    const double t = v + order * std::numbers::pi / 2.0;
    return {(order == 0 ? 7.0 : 0.0) + 3.0 * std::cos(t), 2.0 * std::sin(t)};
  };
}

Jet skewed(const Jet& jet) {
  Eigen::Matrix2d change;
  change << 1.1, 0.4, -0.3, 0.8;
  return reparametrised(jet, change);
}

void expectNone(const Jet& jet) {
  for (const Jet& parametrised : {jet, skewed(jet)}) {
    EXPECT_LT(density(parametrised), 1e-24);
    EXPECT_TRUE(kEnergy.linearised(parametrised).derivatives.allFinite());
  }
}

TEST(MinimumVariation, VanishesOnPlanesWhateverTheirParameters) {
  Random random{2};
  Jet jet = randomJet(random);
  jet.row(2).setZero();
  expectNone(jet);
}

TEST(MinimumVariation, VanishesOnSpheresThoughEveryPointIsAnUmbilic) {
  for (const double v : {-1.2, 0.0, 0.7}) expectNone(revolvedJet(sphereProfile(2.0), 0.4, v));
}

TEST(MinimumVariation, VanishesOnCylindersConesAndTori) {
  for (const double v : {0.3, 1.0, 2.5}) {
    expectNone(revolvedJet(cylinderProfile(2.0), 0.4, v));
    expectNone(revolvedJet(coneProfile(), 0.4, v));
    expectNone(revolvedJet(torusProfile(5.0, 2.0), 0.4, v));
  }
}

TEST(MinimumVariation, OfASurfaceOfRevolution) {
  // Along parallels nothing changes; along the profile it is its curvature a b / speed^3.
  const double v = 0.4, a = 3.0, b = 2.0;
  const double speed2 = a * a * std::pow(std::sin(v), 2) + b * b * std::pow(std::cos(v), 2);
  const double slope = -3.0 * a * b * std::pow(speed2, -2.5) * (a * a - b * b) * std::sin(v) *
                       std::cos(v) / std::sqrt(speed2);
  const double area = (7.0 + a * std::cos(v)) * std::sqrt(speed2);
  const Jet jet = revolvedJet(ellipseProfile(), 0.4, v);
  EXPECT_NEAR(density(jet), slope * slope * area, 1e-13);
}

// z = p(x, y) of third order above a level umbilic: the mean over all directions of the squares of
// the third derivatives along two orthogonal ones.
TEST(MinimumVariation, IsTheMeanOverAllDirectionsAtUmbilics) {
  Jet jet = Jet::Zero();
  jet.col(0) << 1.0, 0.0, 0.0;
  jet.col(1) << 0.0, 1.0, 0.0;
  const double a = 0.3, b = -0.2, c = 0.5, d = 0.7;
  jet.row(2).tail<4>() << a, b, c, d;
  double mean = 0.0;
  constexpr int kDirections = 64;
  for (int k = 0; k < kDirections; ++k) {
    const double x = std::cos(2.0 * std::numbers::pi * k / kDirections);
    const double y = std::sin(2.0 * std::numbers::pi * k / kDirections);
    const double along = a * x * x * x + 3.0 * b * x * x * y + 3.0 * c * x * y * y + d * y * y * y;
    mean += 2.0 * along * along / kDirections;
  }
  EXPECT_NEAR(density(jet), mean, 1e-14);
}

// From an umbilic to where the principal directions are clear, and all that lies between.
TEST(MinimumVariation, DerivativesAreThoseOfDifferences) {
  for (const double umbilic : {0.2, 1.0, 10.0})
    expectExactDerivatives(MinimumVariation(umbilic), 4);
}

TEST(MinimumVariation, DerivativesOnASphereAreThoseOfDifferences) {
  expectExactDerivativesAt(MinimumVariation(0.1), revolvedJet(sphereProfile(1.0), 0.4, 0.5));
}

// On its way to an umbilic the integrand goes over into its mean without a jump.
TEST(MinimumVariation, IsSmoothAtUmbilics) {
  Random random{5};
  Jet jet = randomJet(random), off = randomJet(random);
  jet.col(0) << 1.0, 0.0, 0.0;
  jet.col(1) << 0.0, 1.0, 0.0;
  jet.col(2) << 0.1, 0.2, 0.8;
  jet.col(3) << 0.1, 0.2, 0.0;
  jet.col(4) << 0.1, 0.2, 0.8;
  const MinimumVariation energy(0.05);
  expectExactDerivativesAt(energy, jet + 1e-3 * off);
  EXPECT_NEAR(
      energy.residuals(jet + 1e-9 * off).squaredNorm(), energy.residuals(jet).squaredNorm(), 1e-6);
}

TEST(MinimumVariation, MovesWithRigidMotions) {
  expectRigidInvariance(kEnergy);
}

TEST(MinimumVariation, FallsWithTheSquareOfTheSize) {
  expectScaling(kEnergy);
}

TEST(MinimumVariation, DoesNotDependOnTheParameters) {
  expectParameterInvariance(kEnergy);
  expectParameterInvariance(MinimumVariation(0.5));
}

}  // namespace
}  // namespace fairing::shape_energy
