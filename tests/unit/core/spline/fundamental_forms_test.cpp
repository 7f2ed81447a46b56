// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/fundamental_forms.h"

#include <gmock/gmock.h>

#include <array>

#include "support/known_jets.h"
#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/random_splines.h"

namespace fairing::spline {
namespace {

using namespace ::fairing::testing;  // NOLINT: jets, random splines, derivatives

using Values = Eigen::Matrix<double, 18, 1>;

// Value, derivative along u and along v of E, F, G, L, M, N in turn.
Values flat(const FundamentalForms& forms) {
  Values all;
  Eigen::Index row = 0;
  for (const FirstOrderJet& x : {forms.e, forms.f, forms.g, forms.l, forms.m, forms.n})
    for (const double value : {x.value, x.u, x.v}) all[row++] = value;
  return all;
}

BsplineSurface somePatch() {
  Random random{0};
  const KnotVector knots = randomKnots(random, 5, 2);
  return randomSurface(random, knots, knots);
}

FundamentalForms formsAt(const BsplineSurface& surface, double u, double v) {
  return fundamentalForms(thirdOrderJet(surface.derivatives(u, v, 3)));
}

constexpr double kU = 0.21, kV = 0.77;  // clear of the knots

TEST(ThirdOrderJet, HoldsTheDerivativesInTheOrderNamed) {
  const BsplineSurface s = somePatch();
  const ThirdOrderJet jet = thirdOrderJet(s.derivatives(kU, kV, 3));
  const std::array<std::array<int, 2>, 9> orders{
      {{1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}}};
  for (std::size_t k = 0; k < orders.size(); ++k) {
    const Eigen::Vector3d expected = s.evaluate(kU, kV, orders[k][0], orders[k][1]);
    EXPECT_THAT(jet.col(static_cast<Eigen::Index>(k)), IsNear(expected, 1e-12 * expected.norm()));
  }
}

TEST(FundamentalForms, OfACylinder) {
  const FundamentalForms forms = fundamentalForms(revolvedJet(cylinderProfile(2.0), 0.4, 0.3));
  Values expected = Values::Zero();
  expected[0] = 4.0;   // E
  expected[6] = 1.0;   // G
  expected[9] = -4.0;  // L: W times -E / radius
  EXPECT_THAT(flat(forms), IsNear(expected, 1e-14));
}

TEST(FundamentalForms, DerivativesAreThoseOfTheirDifferences) {
  const BsplineSurface s = somePatch();
  const Values forms = flat(formsAt(s, kU, kV));
  const Values alongU = derivative([&](double u) { return flat(formsAt(s, u, kV)); }, kU, 1e-4);
  const Values alongV = derivative([&](double v) { return flat(formsAt(s, kU, v)); }, kV, 1e-4);
  const double tolerance = 1e-8 * forms.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < 18; k += 3) {
    EXPECT_NEAR(forms[k + 1], alongU[k], tolerance);
    EXPECT_NEAR(forms[k + 2], alongV[k], tolerance);
  }
}

TEST(FundamentalForms, PullBackIsTheGradientWithRespectToTheJet) {
  Random random{1};
  for (int times = 0; times < 20; ++times) {
    const ThirdOrderJet jet = randomJet(random), direction = randomMatrix(random, 3, 9);
    const Values slopes = randomMatrix(random, 18, 1);
    const auto slope = [&](Eigen::Index k) {
      return FirstOrderJet{slopes[3 * k], slopes[3 * k + 1], slopes[3 * k + 2]};
    };
    const ThirdOrderJet gradient =
        pullBack(jet, {slope(0), slope(1), slope(2), slope(3), slope(4), slope(5)});
    const double along = derivative(
        [&](double x) { return slopes.dot(flat(fundamentalForms(jet + x * direction))); }, 0.0);
    EXPECT_NEAR(gradient.cwiseProduct(direction).sum(), along, 1e-9);
  }
}

TEST(FundamentalForms, ChangeOfThePullBackIsThatOfDifferences) {
  Random random{2};
  for (int times = 0; times < 20; ++times) {
    const ThirdOrderJet jet = randomJet(random), along = randomMatrix(random, 3, 9);
    const Values s = randomMatrix(random, 18, 1);
    const FundamentalForms slopes{{s[0], s[1], s[2]},
                                  {s[3], s[4], s[5]},
                                  {s[6], s[7], s[8]},
                                  {s[9], s[10], s[11]},
                                  {s[12], s[13], s[14]},
                                  {s[15], s[16], s[17]}};
    // The forms are of third order in the jet: differences are exact but for rounding.
    const ThirdOrderJet expected =
        0.5 * (pullBack(jet + along, slopes) - pullBack(jet - along, slopes));
    EXPECT_THAT(pullBackChange(jet, along, slopes),
                IsNear(expected, 1e-13 * expected.cwiseAbs().maxCoeff()));
  }
}

}  // namespace
}  // namespace fairing::spline
