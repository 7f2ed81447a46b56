// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/bspline_basis.h"

#include <gmock/gmock.h>

#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/random_splines.h"

namespace fairing::spline {
namespace {

using ::fairing::testing::evenParameters;
using ::fairing::testing::IsNear;
using ::fairing::testing::Random;
using ::fairing::testing::randomKnots;

// Inner knots of every multiplicity up to the degree: the hardest the class admits.
const KnotVector kRepeated{3, {0, 0, 0, 0, 0.3, 0.5, 0.5, 0.8, 0.8, 0.8, 1, 1, 1, 1}};

TEST(BsplineBasis, SumsToOneOnRepeatedKnots) {
  for (const double t : evenParameters(kRepeated, 41))
    EXPECT_NEAR(basisRow(kRepeated, t).values.row(0).sum(), 1.0, 1e-15) << "at " << t;
}

TEST(BsplineBasis, IsNeverNegative) {
  Random random{0};
  for (int degree = 1; degree <= 9; ++degree) {
    const KnotVector knots = randomKnots(random, degree, 5, degree);
    for (const double t : evenParameters(knots, 33))
      EXPECT_GE(basisRow(knots, t).values.row(0).minCoeff(), 0.0);
  }
}

TEST(BsplineBasis, DerivativesSumToZero) {
  Random random{1};
  for (int degree = 2; degree <= 7; ++degree) {
    const KnotVector knots = randomKnots(random, degree, 4);
    for (const double t : evenParameters(knots, 17)) {
      const auto values = basisRow(knots, t, 3).values;
      // Derivatives of order k grow as (degree / span)^k, up to 1e5 here.
      for (int k = 1; k <= 3; ++k) EXPECT_NEAR(values.row(k).sum(), 0.0, 1e-9);
    }
  }
}

TEST(BsplineBasis, FirstAndLastAreOneAtTheEnds) {
  const BasisRow first = basisRow(kRepeated, 0.0), last = basisRow(kRepeated, 1.0);
  EXPECT_EQ(first.first, 0);
  EXPECT_EQ(first.values(0, 0), 1.0);
  EXPECT_EQ(last.first + kRepeated.degree(), kRepeated.poleCount() - 1);
  EXPECT_EQ(last.values(0, kRepeated.degree()), 1.0);
}

TEST(BsplineBasis, EndDerivativeIsDegreeOverFirstSpan) {
  const BasisRow row = basisRow(kRepeated, 0.0, 1);
  EXPECT_NEAR(row.values(1, 0), -3.0 / 0.3, 1e-14);
  EXPECT_NEAR(row.values(1, 1), 3.0 / 0.3, 1e-14);
}

TEST(BsplineBasis, DerivativesAreThoseOfTheValues) {
  Random random{2};
  for (int degree = 3; degree <= 7; ++degree) {
    const KnotVector knots = randomKnots(random, degree, 3);
    const double t = 0.5 * (knots.breaks()[1] + knots.breaks()[2]);
    for (int order = 1; order <= kMaxBasisDerivative; ++order) {
      const auto below = [&](double x) {
        return Eigen::RowVectorXd(basisRow(knots, x, order - 1).values.row(order - 1));
      };
      const Eigen::RowVectorXd exact = basisRow(knots, t, order).values.row(order);
      // Fourth order differences over 1e-3: truncation 1e-12 of the fifth next derivative.
      EXPECT_THAT(exact,
                  IsNear(::fairing::testing::derivative(below, t),
                         1e-7 * (1.0 + exact.cwiseAbs().maxCoeff())))
          << "degree " << degree << ", order " << order;
    }
  }
}

TEST(BsplineBasis, DerivativesAboveTheDegreeVanish) {
  const auto values = basisRow(KnotVector::bezier(2), 0.4, 4).values;
  EXPECT_EQ(values.row(3).norm(), 0.0);
  EXPECT_EQ(values.row(4).norm(), 0.0);
}

TEST(BsplineBasis, ParametersOutsideTheDomainAreClamped) {
  EXPECT_EQ(basisRow(kRepeated, -1.0).values, basisRow(kRepeated, 0.0).values);
  EXPECT_EQ(basisRow(kRepeated, 2.0).values, basisRow(kRepeated, 1.0).values);
}

TEST(BsplineBasis, BezierCaseIsBernstein) {
  const double t = 0.3, s = 1.0 - t;
  const Eigen::RowVector4d bernstein(s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t);
  EXPECT_THAT(Eigen::RowVectorXd(basisRow(KnotVector::bezier(3), t).values.row(0)),
              IsNear(bernstein, 1e-15));
}

TEST(CollocationMatrix, TakesGrevilleAbscissaeBackToParameters) {
  Random random{3};
  const KnotVector knots = randomKnots(random, 5, 4, 2);
  const std::vector<double> parameters = evenParameters(knots, 15);
  const std::vector<double> greville = knots.grevilleAbscissae();
  const Eigen::VectorXd poles =
      Eigen::Map<const Eigen::VectorXd>(greville.data(), knots.poleCount());
  const Eigen::VectorXd expected = Eigen::Map<const Eigen::VectorXd>(parameters.data(), 15);
  EXPECT_THAT(Eigen::VectorXd(collocationMatrix(knots, parameters) * poles),
              IsNear(expected, 1e-14));
  EXPECT_THAT(Eigen::VectorXd(collocationMatrix(knots, parameters, 1) * poles),
              IsNear(Eigen::VectorXd::Ones(15), 1e-13));
}

}  // namespace
}  // namespace fairing::spline
