// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/measure_fill.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "support/known_loops.h"
#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::analysis {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using boundary::BoundaryLoop;
using Eigen::Vector3d;
using spline::BsplineSurface;
using spline::KnotVector;

constexpr double kDegrees = 180.0 / std::numbers::pi;

BsplineSurface flatPatch() {
  const KnotVector k = KnotVector::bezier(3);
  return interpolated([](double u, double v) { return Vector3d(u, v, 0.0); }, k, k);
}

BsplineSurface movedPatch(BsplineSurface patch, const Eigen::Affine3d& motion) {
  for (Eigen::Index k = 0; k < patch.poles.rows(); ++k)
    patch.poles.row(k) = (motion * Vector3d(patch.poles.row(k).transpose())).transpose();
  return patch;
}

FillReport measure(const BoundaryLoop& loop, const BsplineSurface& patch) {
  const auto c = unitSquare();
  std::vector<SideTrace> traces;
  for (std::size_t k = 0; k < 4; ++k)
    traces.push_back({static_cast<int>(k), 0, 0.0, 1.0, c[k], c[(k + 1) % 4]});
  return measureFill(loop, probeLoop(loop), {patch}, traces, {});
}

TEST(MeasureFill, APatchAgainstItsOwnBorderHasNoDeviation) {
  Random random{0};
  const KnotVector u = randomKnots(random, 4, 3), v = randomKnots(random, 5, 2);
  const BsplineSurface patch = randomSurface(random, u, v, 0.05);
  const FillReport report = measure(finished(borderOf(patch)), patch);
  EXPECT_TRUE(report.withinTolerance);
  EXPECT_LT(report.largestGap, 1e-13);
  EXPECT_LT(report.largestAngle, 1e-6);
  EXPECT_LT(report.largestCornerAngle, 1e-6);
  for (const SideReport& side : report.sides) EXPECT_LT(side.curvature.max, 1e-6);
}

TEST(MeasureFill, APatchLiftedByAKnownWayHasThatGap) {
  const BsplineSurface patch =
      movedPatch(flatPatch(), Eigen::Affine3d(Eigen::Translation3d(0.0, 0.0, 1e-3)));
  const FillReport report = measure(loopOf(plane(), unitSquare()), patch);
  for (const SideReport& side : report.sides) {
    EXPECT_NEAR(side.gap.max, 1e-3, 1e-12);
    EXPECT_NEAR(side.gap.rms, 1e-3, 1e-12);
    EXPECT_FALSE(side.withinTolerance);
  }
  EXPECT_LT(report.largestAngle, 1e-6);
}

TEST(MeasureFill, APatchTurnedByAKnownAngleHasThatAngle) {
  const double turn = 3.0;
  const BsplineSurface patch = movedPatch(
      flatPatch(), Eigen::Affine3d(Eigen::AngleAxisd(turn / kDegrees, Vector3d::UnitX())));
  const FillReport report = measure(loopOf(plane(), unitSquare()), patch);
  for (const SideReport& side : report.sides) {
    EXPECT_NEAR(side.angle.max, turn, 1e-9);
    EXPECT_NEAR(side.angle.rms, turn, 1e-9);
    EXPECT_NEAR(side.cornerAngle.max, turn, 1e-9);
  }
  // Turned about the South side: no gap there; the North one is a sine away from the plane.
  EXPECT_LT(report.sides[0].gap.max, 1e-12);
  EXPECT_NEAR(report.sides[2].gap.max, std::sin(turn / kDegrees), 1e-9);
  EXPECT_NEAR(report.sides[1].gap.max, std::sin(turn / kDegrees), 1e-9);
  EXPECT_THAT(report.sides[1].gap.where, IsNear(Vector3d(1.0, 1.0, 0.0), 1e-12));
  EXPECT_FALSE(report.withinTolerance);
}

TEST(MeasureFill, CurvatureIsComparedAcrossTheSide) {
  // A flat patch beside a cylinder that touches it along one side: all of the curvature differs.
  Sides sides = sidesOf(plane(), unitSquare());
  sides[0].ribbon.support = [flat = sides[0].ribbon.support](double t) {
    auto s = flat(t);
    s.secondForm = Eigen::Vector3d(0.0, 1.0, 0.0).asDiagonal();
    return s;
  };
  const FillReport report = measure(finished(sides), flatPatch());
  EXPECT_GT(report.sides[0].curvature.max, 0.9);
  EXPECT_LT(report.sides[1].curvature.max, 1e-9);
}

TEST(MeasureFill, ATransposedPatchIsReversedAndAsGood) {
  const BoundaryLoop loop = loopOf(plane(), unitSquare());
  const BsplineSurface patch = spline::transposed(flatPatch());
  std::vector<SideTrace> traces;
  const auto c = unitSquare();
  for (std::size_t k = 0; k < 4; ++k)
    traces.push_back({static_cast<int>(k), 0, 0.0, 1.0, c[k].reverse(), c[(k + 1) % 4].reverse()});
  const FillReport report = measureFill(loop, probeLoop(loop), {patch}, traces, {});
  EXPECT_TRUE(report.reversed);
  EXPECT_TRUE(report.withinTolerance);
  EXPECT_FALSE(report.sides[0].backwards);
}

TEST(MeasureFill, APatchThatLeavesASideBackwardsIsNoticed) {
  // In the plane all angles are zero, but the patch first runs under its neighbour: a cusp.
  BsplineSurface patch = flatPatch();
  for (int i = 0; i < 4; ++i) patch.poles(patch.index(i, 1), 1) = -0.2;
  const FillReport report = measure(loopOf(plane(), unitSquare()), patch);
  EXPECT_TRUE(report.sides[0].backwards);
  EXPECT_FALSE(report.sides[0].withinTolerance);
  EXPECT_FALSE(report.withinTolerance);
}

TEST(MeasureFill, G0SidesAreNotJudgedByTheirAngle) {
  Sides sides = sidesOf(plane(), unitSquare());
  for (auto& side : sides) side.continuity = Continuity::G0;
  BsplineSurface bent = flatPatch();
  for (const int i : {1, 2})
    for (const int j : {1, 2}) bent.poles(bent.index(i, j), 2) = 0.3;
  const FillReport report = measure(finished(sides), bent);
  EXPECT_GT(report.sides[0].angle.max, 10.0);  // measured all the same
  EXPECT_TRUE(report.withinTolerance);
}

TEST(MeasureFill, CornersAreHandedOn) {
  const FillReport report = measure(finished(incompatibleTwists(0.5)), flatPatch());
  ASSERT_EQ(report.corners.size(), 4U);
  EXPECT_EQ(report.corners[0].edgeBefore, 1);
  EXPECT_EQ(report.corners[0].edgeAfter, 2);
  EXPECT_EQ(report.corners[3].edgeAfter, 1);
  EXPECT_NEAR(report.corners[0].angle, 90.0, 1e-9);
  EXPECT_FALSE(report.corners[0].twistsAgree);
  EXPECT_TRUE(report.corners[0].normalsAgree);
}

TEST(MeasureFill, LimitsAreThoseOfTheTolerance) {
  const BoundaryLoop loop = loopOf(plane(), unitSquare());
  const FillReport report = measure(loop, flatPatch());
  EXPECT_NEAR(report.gapLimit, 1e-6 * loop.diagonal, 1e-18);
  EXPECT_EQ(report.angleLimit, Tolerance{}.angle);
  EXPECT_EQ(report.cornerAngleLimit, Tolerance{}.cornerAngle);
}

}  // namespace
}  // namespace fairing::analysis
