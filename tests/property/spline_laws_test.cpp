// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Laws of splines for knots and poles of any kind.
#include <gmock/gmock.h>
#include <rapidcheck.h>

#include "core/spline/bspline_basis.h"
#include "core/spline/bspline_curve.h"
#include "support/random_splines.h"

namespace fairing::spline {
namespace {

using namespace ::fairing::testing;  // NOLINT: random splines

constexpr double kRounding = 1e-12;  // poles of size 1, degrees up to 8

BsplineCurve someCurve(int mostDegree) {
  const int degree = *rc::gen::inRange(1, mostDegree + 1), spans = *rc::gen::inRange(1, 7);
  Random random{static_cast<unsigned>(*rc::gen::inRange(0, 100000))};
  return randomCurve(random, randomKnots(random, degree, spans, *rc::gen::inRange(1, degree + 1)));
}

double parameter() {
  return *rc::gen::inRange(0, 1001) * 1e-3;
}

double difference(const BsplineCurve& a, const BsplineCurve& b) {
  double worst = 0.0;
  for (const double t : evenParameters(a.knots, 29))
    worst = std::max(worst, (a.evaluate(t) - b.evaluate(t)).norm());
  return worst;
}

TEST(SplineLaws, BasisIsAPartitionOfUnity) {
  EXPECT_TRUE(rc::check([] {
    const BsplineCurve curve = someCurve(8);
    RC_ASSERT(std::abs(basisRow(curve.knots, parameter()).values.row(0).sum() - 1.0) < 1e-14);
  }));
}

TEST(SplineLaws, InsertingAnyKnotKeepsTheCurve) {
  EXPECT_TRUE(rc::check([] {
    const BsplineCurve curve = someCurve(8);
    const double t = 0.001 + 0.998 * parameter();
    RC_ASSERT(difference(curve, insertKnot(curve, t)) < kRounding);
  }));
}

TEST(SplineLaws, RaisingTheDegreeKeepsTheCurve) {
  EXPECT_TRUE(rc::check([] {
    const BsplineCurve curve = someCurve(5);
    RC_ASSERT(difference(curve, raiseDegree(curve, *rc::gen::inRange(1, 4))) < kRounding);
  }));
}

TEST(SplineLaws, RaisingAndInsertingCommute) {
  EXPECT_TRUE(rc::check([] {
    const BsplineCurve curve = someCurve(5);
    const double t = 0.001 + 0.998 * parameter();
    const BsplineCurve a = insertKnot(insertKnot(raiseDegree(curve, 1), t), t);
    const BsplineCurve b = raiseDegree(insertKnot(curve, t), 1);
    RC_ASSERT(difference(a, b) < kRounding);
  }));
}

TEST(SplineLaws, AffineMapsActOnThePoles) {
  EXPECT_TRUE(rc::check([] {
    const BsplineCurve curve = someCurve(8);
    Random random{static_cast<unsigned>(*rc::gen::inRange(0, 1000))};
    const Eigen::Matrix3d linear = randomMatrix(random, 3, 3);
    const Eigen::Vector3d shift = randomVector(random);
    BsplineCurve mapped = curve;
    mapped.poles = (curve.poles * linear.transpose()).rowwise() + shift.transpose();
    const double t = parameter();
    RC_ASSERT((mapped.evaluate(t) - (linear * curve.evaluate(t) + shift)).norm() < kRounding);
  }));
}

TEST(SplineLaws, ACurveStaysInTheBoxOfItsPoles) {
  EXPECT_TRUE(rc::check([] {
    const BsplineCurve curve = someCurve(8);
    const Eigen::Array3d p = curve.evaluate(parameter()).array();
    const Eigen::Array3d low = curve.poles.colwise().minCoeff().transpose().array();
    const Eigen::Array3d high = curve.poles.colwise().maxCoeff().transpose().array();
    RC_ASSERT((p >= low - kRounding).all() && (p <= high + kRounding).all());
  }));
}

}  // namespace
}  // namespace fairing::spline
