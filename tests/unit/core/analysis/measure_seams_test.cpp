// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/measure_seams.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/random_splines.h"

namespace fairing::analysis {
namespace {

using namespace ::fairing::testing;  // NOLINT: splines made of formulas
using Eigen::Vector3d;
using spline::BsplineSurface;

constexpr double kDegrees = std::numbers::pi / 180.0;
constexpr double kDiagonal = 2.0;

BsplineSurface patchOf(const PointFunction& function) {
  const auto knots = spline::KnotVector::bezier(3);
  return interpolated(function, knots, knots);
}

BsplineSurface flat() {
  return patchOf([](double u, double v) { return Vector3d(u, v, 0.0); });
}

// The seam x = 1 of a patch over [0, 1] and one over [1, 2], upwards.
const SeamTraces kSeam{{0, {1.0, 0.0}, {1.0, 1.0}}, {1, {0.0, 0.0}, {0.0, 1.0}}};

SeamReport measuredSeam(const BsplineSurface& first, const BsplineSurface& second) {
  return measureSeams({first, second}, {kSeam}, kDiagonal).front();
}

TEST(MeasureSeams, FindsNothingWhereAPatchGoesOn) {
  const auto bent = [](double x, double y) { return Vector3d(x, y, 0.3 * x * x + 0.1 * x * y); };
  const SeamReport seam =
      measuredSeam(patchOf(bent), patchOf([&](double u, double v) { return bent(1.0 + u, v); }));
  EXPECT_EQ(seam.patch, 0);
  EXPECT_EQ(seam.other, 1);
  EXPECT_LT(seam.gap.max, 1e-14);
  EXPECT_LT(seam.angle.max, 1e-6);
  EXPECT_LT(seam.curvature.max, 1e-10);
  EXPECT_GT(seam.gap.count, 10);
}

TEST(MeasureSeams, FindsAKnownKink) {
  const double angle = 3.0;
  const BsplineSurface tilted = patchOf([&](double u, double v) {
    return Vector3d(1.0 + u * std::cos(angle * kDegrees), v, u * std::sin(angle * kDegrees));
  });
  const SeamReport seam = measuredSeam(flat(), tilted);
  EXPECT_LT(seam.gap.max, 1e-14);
  EXPECT_NEAR(seam.angle.max, angle, 1e-9);
  EXPECT_NEAR(seam.angle.rms, angle, 1e-9);
}

TEST(MeasureSeams, FindsAKnownGapAndItsPlace) {
  const BsplineSurface lifted =
      patchOf([](double u, double v) { return Vector3d(1.0 + u, v, 0.01 * 4.0 * v * (1.0 - v)); });
  const SeamReport seam = measuredSeam(flat(), lifted);
  EXPECT_NEAR(seam.gap.max, 0.01, 1e-6);
  EXPECT_NEAR(seam.gap.parameter, 0.5, 0.05);
  EXPECT_NEAR(seam.gap.where.y(), 0.5, 0.05);
}

TEST(MeasureSeams, FindsAKnownStepOfTheCurvature) {
  // Normal curvature 0.4 beyond the seam, none before it.
  const BsplineSurface bent =
      patchOf([](double u, double v) { return Vector3d(1.0 + u, v, 0.2 * u * u); });
  const SeamReport seam = measuredSeam(flat(), bent);
  EXPECT_LT(seam.angle.max, 1e-6);
  EXPECT_NEAR(seam.curvature.max, 0.4 / (0.4 + 0.01 / kDiagonal), 1e-9);
}

TEST(MeasureSeams, ASeamOverTheLimitSpoilsTheVerdict) {
  FillReport report;
  report.diagonal = kDiagonal;
  report.gapLimit = 1e-6;
  report.angleLimit = 0.02;
  report.withinTolerance = true;
  FillReport good = report;
  addSeams(good,
           {flat(), patchOf([](double u, double v) { return Vector3d(1.0 + u, v, 0.0); })},
           {kSeam});
  EXPECT_TRUE(good.withinTolerance);
  FillReport bad = report;
  addSeams(bad,
           {flat(), patchOf([](double u, double v) { return Vector3d(1.0 + u, v, 0.01 * u); })},
           {kSeam});
  EXPECT_FALSE(bad.withinTolerance);
  EXPECT_NEAR(bad.largestSeamAngle, std::atan(0.01) / kDegrees, 1e-9);
  EXPECT_EQ(bad.seams.size(), 1U);
}

}  // namespace
}  // namespace fairing::analysis
