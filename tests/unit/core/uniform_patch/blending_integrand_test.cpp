// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/blending_integrand.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/shape_energy/mean_curvature_gradient.h"
#include "support/known_jets.h"
#include "support/numerical_derivative.h"

namespace fairing::uniform_patch {
namespace {

using namespace ::fairing::testing;  // NOLINT: jets, derivatives
using spline::ThirdOrderJet;
using Hessian = Eigen::Matrix<double, 27, 27>;
using Gradient = Eigen::Matrix<double, 27, 1>;

constexpr double kWeight = 0.7;

JetOf<double> numbersOf(const ThirdOrderJet& jet) {
  JetOf<double> numbers;
  std::copy(jet.data(), jet.data() + 27, numbers.begin());
  return numbers;
}

BlendingDerivatives<double> derivatives(const ThirdOrderJet& jet, double weight = kWeight) {
  BlendingDerivatives<double> result;
  blendingDerivatives(numbersOf(jet), weight, result);
  return result;
}

double valueAt(const ThirdOrderJet& jet) {
  const BlendingValue<double> value = blendingValue(numbersOf(jet));
  return value.shape + kWeight * value.parametrisation;
}

Gradient gradientAt(const ThirdOrderJet& jet) {
  BlendingDerivatives<double> result;
  blendingGradient(numbersOf(jet), kWeight, result);
  return Eigen::Map<Gradient>(result.gradient.data());
}

Hessian hessianOf(const BlendingDerivatives<double>& result) {
  Hessian hessian;
  for (int k = 0; k < 9; ++k)
    for (int l = 0; l <= k; ++l)
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d) {
          const int block = BlendingDerivatives<double>::blockIndex(k, l);
          hessian(3 * k + c, 3 * l + d) = hessian(3 * l + d, 3 * k + c) =
              result.hessian[std::size_t(9 * block + 3 * c + d)];
        }
  return hessian;
}

ThirdOrderJet moved(ThirdOrderJet jet, int entry, double by) {
  jet.data()[entry] += by;
  return jet;
}

// Differences are good to 1e-9 of derivatives of size 1 to 100.
void expectExactDerivatives(const ThirdOrderJet& jet) {
  const BlendingDerivatives<double> all = derivatives(jet);
  const Gradient gradient = Eigen::Map<const Gradient>(all.gradient.data());
  const Hessian hessian = hessianOf(all);
  EXPECT_EQ(gradient, gradientAt(jet));
  EXPECT_NEAR(all.value.shape + kWeight * all.value.parametrisation, valueAt(jet), 1e-13);
  const double size = 1.0 + hessian.cwiseAbs().maxCoeff();
  for (int entry = 0; entry < 27; ++entry) {
    EXPECT_NEAR(gradient[entry],
                derivative([&](double by) { return valueAt(moved(jet, entry, by)); }, 0.0),
                1e-8 * size);
    const Gradient column =
        derivative([&](double by) -> Gradient { return gradientAt(moved(jet, entry, by)); }, 0.0);
    EXPECT_LT((hessian.col(entry) - column).cwiseAbs().maxCoeff(), 1e-8 * size) << entry;
  }
}

TEST(BlendingIntegrand, HasTheDerivativesOfDifferences) {
  Random random{1};
  for (int k = 0; k < 5; ++k) expectExactDerivatives(randomJet(random));
}

TEST(BlendingIntegrand, IsNoTrapAtUmbilics) {
  expectExactDerivatives(revolvedJet(sphereProfile(2.0), 0.4, 0.3));
  Random random{2};
  ThirdOrderJet plane = randomJet(random);
  plane.row(2).setZero();
  expectExactDerivatives(plane);
}

TEST(BlendingIntegrand, IsTheEnergyOfTheMeanCurvatureGradient) {
  Random random{3};
  for (int k = 0; k < 5; ++k) {
    const ThirdOrderJet jet = randomJet(random);
    EXPECT_NEAR(blendingValue(numbersOf(jet)).shape,
                shape_energy::MeanCurvatureGradient().residuals(jet).squaredNorm(),
                1e-13);
  }
}

TEST(BlendingIntegrand, ProjectsTheGradientOfTheLaplacianOntoTheTangentPlane) {
  ThirdOrderJet jet = ThirdOrderJet::Zero();
  jet.col(0) = Eigen::Vector3d(2.0, 0.0, 0.0);
  jet.col(1) = Eigen::Vector3d(1.0, 3.0, 0.0);
  jet.col(5) = Eigen::Vector3d(1.0, 2.0, 7.0);   // R_uuu
  jet.col(7) = Eigen::Vector3d(0.5, 0.0, -2.0);  // R_uvv
  jet.col(8) = Eigen::Vector3d(0.0, -1.0, 4.0);  // R_vvv
  EXPECT_NEAR(blendingValue(numbersOf(jet)).parametrisation, 1.5 * 1.5 + 4.0 + 1.0, 1e-14);
}

TEST(BlendingIntegrand, IsTheSameInEveryLane) {
  Random random{4};
  JetOf<Lanes> jets;
  std::array<ThirdOrderJet, kLanes> single;
  for (int s = 0; s < kLanes; ++s) {
    single[std::size_t(s)] = randomJet(random);
    for (std::size_t k = 0; k < 27; ++k) jets[k][s] = single[std::size_t(s)].data()[k];
  }
  BlendingDerivatives<Lanes> lanes;
  blendingDerivatives(jets, kWeight, lanes);
  for (int s = 0; s < kLanes; ++s) {
    const BlendingDerivatives<double> alone = derivatives(single[std::size_t(s)]);
    EXPECT_DOUBLE_EQ(lanes.value.shape[s], alone.value.shape);
    for (std::size_t k = 0; k < 405; ++k)
      EXPECT_NEAR(
          lanes.hessian[k][s], alone.hessian[k], 1e-13 * (1.0 + std::abs(alone.hessian[k])));
  }
}

}  // namespace
}  // namespace fairing::uniform_patch
