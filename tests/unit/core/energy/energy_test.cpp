// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/energy.h"

#include <gmock/gmock.h>

#include "core/energy/gram.h"
#include "core/spline/bspline_basis.h"
#include "core/spline/quadrature.h"
#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::energy {
namespace {

using ::fairing::testing::IsNear;
using ::fairing::testing::Random;
using ::fairing::testing::randomKnots;

TEST(GramMatrix, IsTheIntegralOfProductsOfBasisFunctions) {
  Random random{0};
  for (int degree = 2; degree <= 6; ++degree) {
    const spline::KnotVector knots = randomKnots(random, degree, 3, 2);
    for (int a = 0; a <= 2; ++a)
      for (int b = 0; b <= 2; ++b) {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(knots.poleCount(), knots.poleCount());
        for (const auto& q : spline::gaussLegendre(12, knots))
          sum += q.weight * spline::collocationMatrix(knots, {q.parameter}, a).transpose() *
                 spline::collocationMatrix(knots, {q.parameter}, b);
        EXPECT_THAT(gramMatrix(knots, a, b),
                    IsNear(sum, 1e-13 * (1.0 + sum.cwiseAbs().maxCoeff())));
      }
  }
}

TEST(GramMatrix, TransposesWithTheOrders) {
  Random random{1};
  const spline::KnotVector knots = randomKnots(random, 4, 3);
  const Eigen::MatrixXd swapped = gramMatrix(knots, 0, 2).transpose();
  EXPECT_THAT(gramMatrix(knots, 2, 0), IsNear(swapped, 1e-12));
}

TEST(GramMatrix, OfValuesSumsToTheDomain) {
  const spline::KnotVector knots = spline::KnotVector::fromBreaks(3, {2.0, 3.0, 5.0});
  EXPECT_NEAR(gramMatrix(knots, 0, 0).sum(), 3.0, 1e-13);
}

TEST(EnergyTerms, EveryChoiceHasItsTerms) {
  EXPECT_EQ(energyTerms(EnergyKind::Membrane).size(), 2U);
  EXPECT_EQ(energyTerms(EnergyKind::ThinPlate).size(), 3U);
}

}  // namespace
}  // namespace fairing::energy
