// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/constraint_normal.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/known_loops.h"
#include "support/matchers.h"
#include "support/numerical_derivative.h"

namespace fairing::boundary {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

Ribbon someRibbon() {
  return sideOn(waves(), bow({0.1, 0.2}, {1.0, 0.7}, 0.1), 0).ribbon;
}

TEST(ConstraintNormal, IsTheSupportNormalWhereTheEdgeLiesOnTheFace) {
  const Ribbon ribbon = someRibbon();
  for (const double t : {0.0, 0.3, 1.0})
    EXPECT_THAT(constraintNormal(ribbon, t), IsNear(ribbon.support(t).normal, 1e-14));
}

TEST(ConstraintNormal, IsMadePerpendicularToAnEdgeThatLeavesTheFace) {
  Ribbon ribbon = someRibbon();
  ribbon.support = [exact = ribbon.support](double t) {
    SupportSample s = exact(t);
    s.normal = (s.normal + 1e-3 * Eigen::Vector3d(1.0, 1.0, 0.0)).normalized();
    return s;
  };
  for (const double t : {0.0, 0.3, 1.0}) {
    const Eigen::Vector3d n = constraintNormal(ribbon, t);
    EXPECT_NEAR(n.dot(ribbon.curve(t).derivative), 0.0, 1e-14);
    EXPECT_NEAR(n.norm(), 1.0, 1e-14);
    EXPECT_GT(n.dot(ribbon.support(t).normal), std::cos(2e-3));
  }
}

TEST(ConstraintNormal, IsNotANumberWhereTheSupportIsSingular) {
  Ribbon ribbon = someRibbon();
  ribbon.support = [](double) {
    SupportSample s;
    s.singular = true;
    return s;
  };
  EXPECT_TRUE(constraintNormal(ribbon, 0.5).array().isNaN().all());
}

TEST(ConstraintNormal, EndDerivativesAreThoseOfTheNormal) {
  const Ribbon ribbon = someRibbon();  // formulas go on beyond the ends: central differences do too
  const auto normal = [&](double t) { return constraintNormal(ribbon, t); };
  for (const bool atStart : {true, false})
    EXPECT_THAT(constraintNormalDerivativeAtEnd(ribbon, atStart),
                IsNear(derivative(normal, atStart ? 0.0 : 1.0), 1e-9));
}

}  // namespace
}  // namespace fairing::boundary
