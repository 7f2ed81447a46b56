// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/measure_guidance.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::analysis {
namespace {

using namespace ::fairing::testing;  // NOLINT: random splines
using Eigen::Vector3d;
using energy::GuidanceSample;
using spline::KnotVector;

constexpr double kTilt = 10.0;  // degrees

/// The unit square in the plane z = 0.
spline::BsplineSurface square() {
  const KnotVector knots = KnotVector::fromBreaks(3, {0.0, 0.4, 1.0});
  return interpolated([](double u, double v) { return Vector3d(u, v, 0.0); }, knots, knots);
}

Vector3d tilted(double degrees) {
  const double a = degrees * M_PI / 180.0;
  return {std::sin(a), 0.0, std::cos(a)};
}

TEST(MeasureGuidance, GivesTheAngleAndDistanceOfATiltedPlane) {
  energy::Guidance guidance;  // no weight: the guide is measured all the same
  guidance.reference = [](const Vector3d& near) {
    return GuidanceSample{tilted(kTilt), near + Vector3d(0, 0, 2), 1.0, 1.0};
  };
  const auto report = measureGuidance(guidance, {square()});
  ASSERT_TRUE(report.has_value());
  EXPECT_NEAR(report->rmsAngle, kTilt, 1e-12);
  EXPECT_NEAR(report->largestAngle, kTilt, 1e-12);
  EXPECT_NEAR(report->rmsDistance, 2.0, 1e-14);
  EXPECT_EQ(report->covered, 1.0);
}

TEST(MeasureGuidance, DoesNotTellANormalFromItsOpposite) {
  energy::Guidance guidance;
  guidance.parametric = [](double, double) {
    return GuidanceSample{-tilted(kTilt), Vector3d::Zero(), 1.0, 0.0};
  };
  const auto report = measureGuidance(guidance, {square()});
  EXPECT_NEAR(report->rmsAngle, kTilt, 1e-12);
  EXPECT_EQ(report->points, 0);
}

TEST(MeasureGuidance, WeighsTheMeanAndFindsTheWorstPlace) {
  energy::Guidance guidance;
  guidance.parametric = [](double u, double) {
    // Three quarters of the square at weight 1, the rest at weight 3 and twice the angle.
    const bool far = u > 0.7;
    return GuidanceSample{
        tilted(far ? 2.0 * kTilt : kTilt), Vector3d::Zero(), far ? 3.0 : 1.0, 0.0};
  };
  const auto report = measureGuidance(guidance, {square()});
  EXPECT_NEAR(report->largestAngle, 2.0 * kTilt, 1e-12);
  EXPECT_GT(report->where.x(), 0.7);
  EXPECT_GT(report->rmsAngle, kTilt * std::sqrt(0.5 + 0.5 * 4.0));
  EXPECT_LT(report->rmsAngle, 2.0 * kTilt);
}

TEST(MeasureGuidance, LeavesOutWhatIsTrimmedAway) {
  energy::Guidance guidance;
  guidance.parametric = [](double u, double) {
    return GuidanceSample{tilted(u > 0.5 ? 40.0 : kTilt), Vector3d::Zero(), 1.0, 0.0};
  };
  const auto report =
      measureGuidance(guidance, {square()}, [](std::size_t, double u, double) { return u < 0.5; });
  EXPECT_NEAR(report->largestAngle, kTilt, 1e-12);
}

TEST(MeasureGuidance, TellsHowMuchAReferenceCovers) {
  energy::Guidance guidance;
  guidance.reference = [](const Vector3d& near) {
    const double known = near.x() < 0.4 ? 1.0 : 0.0;  // a knot, so exact
    return GuidanceSample{Vector3d::UnitZ(), near, known, known};
  };
  FillReport report;
  ASSERT_TRUE(addGuidance(report, guidance, {square()}).has_value());
  EXPECT_NEAR(report.guidance->covered, 0.4, 1e-12);
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_NEAR(report.notes[0].value, 0.6, 1e-12);
}

TEST(MeasureGuidance, FindsHandlesThatReachNothing) {
  energy::Guidance guidance;
  guidance.handles = {{Vector3d(0.5, 0.5, 0.0), tilted(kTilt), 1.0, 0.3},
                      {Vector3d(3.5, 0.5, 2.0), tilted(kTilt), 1.0, 1.0}};
  const auto report = measureGuidance(guidance, {square()});
  ASSERT_THAT(report, FailsWith(ErrorCode::HandleOff));
  EXPECT_EQ(report.error().detail, "Handle 2");
  EXPECT_NEAR(report.error().value, 2.5, 1e-12);
  guidance.handles.pop_back();
  EXPECT_NEAR(measureGuidance(guidance, {square()})->rmsAngle, kTilt, 1e-12);
}

TEST(MeasureGuidance, SaysNothingWhereNothingGuides) {
  FillReport report;
  ASSERT_TRUE(addGuidance(report, {}, {square()}).has_value());
  EXPECT_FALSE(report.guidance.has_value());
}

}  // namespace
}  // namespace fairing::analysis
