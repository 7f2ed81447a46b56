// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/shape_energy_laws.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "support/known_jets.h"
#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/random_splines.h"

namespace fairing::testing {
namespace {

using shape_energy::Jet;
using shape_energy::Residuals;
using shape_energy::ShapeEnergy;

constexpr int kTimes = 20;

double density(const ShapeEnergy& energy, const Jet& jet) {
  return energy.residuals(jet).squaredNorm();
}

// Value, gradient and second derivatives of the density.
void expectExactExpansionAt(const ShapeEnergy& energy, const Jet& jet) {
  using Flat = Eigen::Map<const Eigen::Matrix<double, 27, 1>>;
  const shape_energy::DensityExpansion exact = energy.expanded(jet);
  const shape_energy::ResidualsWithDerivatives r = energy.linearised(jet);
  const Eigen::VectorXd gradient = 2.0 * r.derivatives.transpose() * r.values;
  const double slope = gradient.cwiseAbs().maxCoeff();
  EXPECT_NEAR(exact.value, r.values.squaredNorm(), 1e-12 * r.values.squaredNorm());
  EXPECT_THAT(Flat(exact.gradient.data()), IsNear(gradient, 1e-10 * slope));
  const double scale = exact.hessian.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < 27; ++k) {
    Jet unit = Jet::Zero();
    unit.data()[k] = 1.0;
    const Jet numerical =
        derivative([&](double x) { return energy.expanded(jet + x * unit).gradient; }, 0.0, 1e-4);
    EXPECT_THAT(exact.hessian.col(k), IsNear(Flat(numerical.data()), 1e-7 * scale))
        << "jet entry " << k;
  }
}

}  // namespace

void expectExactDerivativesAt(const ShapeEnergy& energy, const Jet& jet) {
  const shape_energy::ResidualsWithDerivatives exact = energy.linearised(jet);
  EXPECT_EQ(exact.values, energy.residuals(jet));
  const double scale = exact.derivatives.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < 27; ++k) {
    Jet unit = Jet::Zero();
    unit.data()[k] = 1.0;
    const Residuals numerical =
        derivative([&](double x) { return energy.residuals(jet + x * unit); }, 0.0, 1e-4);
    EXPECT_THAT(exact.derivatives.col(k), IsNear(numerical, 1e-8 * scale)) << "jet entry " << k;
  }
  expectExactExpansionAt(energy, jet);
}

void expectExactDerivatives(const ShapeEnergy& energy, Eigen::Index residuals) {
  Random random{1};
  for (int times = 0; times < kTimes; ++times) {
    const Jet jet = randomJet(random);
    ASSERT_EQ(energy.linearised(jet).derivatives.rows(), residuals);
    expectExactDerivativesAt(energy, jet);
  }
}

void expectRigidInvariance(const ShapeEnergy& energy) {
  Random random{2};
  for (int times = 0; times < kTimes; ++times) {
    const Jet jet = randomJet(random);
    const Eigen::AngleAxisd turn(1.3, randomVector(random).normalized());
    const Residuals expected = energy.residuals(jet);
    EXPECT_THAT(energy.residuals(turn.toRotationMatrix() * jet),
                IsNear(expected, 1e-12 * expected.norm()));
  }
}

void expectScaling(const ShapeEnergy& energy) {
  Random random{3};
  for (int times = 0; times < kTimes; ++times) {
    const Jet jet = randomJet(random);
    const double expected = density(energy, jet) * std::pow(10.0, energy.sizePower());
    EXPECT_NEAR(density(energy, 10.0 * jet), expected, 1e-12 * expected);
  }
}

void expectParameterInvariance(const ShapeEnergy& energy) {
  Random random{4};
  for (int times = 0; times < kTimes; ++times) {
    const Jet jet = randomJet(random);
    // Well away from singular; every second one turns the normal round.
    Eigen::Matrix2d change = Eigen::Matrix2d::Identity() + 0.4 * randomMatrix(random, 2, 2);
    if (times % 2 == 1) change.col(0) *= -1.0;
    const double expected = density(energy, jet) * std::abs(change.determinant());
    EXPECT_NEAR(density(energy, reparametrised(jet, change)), expected, 1e-11 * expected);
  }
}

}  // namespace fairing::testing
