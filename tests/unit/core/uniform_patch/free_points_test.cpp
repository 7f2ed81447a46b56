// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/free_points.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/known_nets.h"

namespace fairing::uniform_patch {
namespace {

using namespace ::fairing::testing;  // NOLINT: nets
using Constant = FixedCurve::Constant;

// Any moves of the free points.
ControlNet movedFreely(const ConstrainedNet& constrained) {
  ControlNet net = constrained.net;
  const spline::Poles moves = spline::Poles::Random(constrained.free.count, 3);
  net.points += constrained.free.spread(moves);
  return net;
}

double distanceAlong(Constant constant,
                     double parameter,
                     const ControlNet& a,
                     const ControlNet& b) {
  double largest = 0.0;
  const double last = constant == Constant::U ? a.columns : a.rows;
  for (double t = 3.0; t <= last; t += 0.37) {
    const double u = constant == Constant::U ? parameter : t,
                 v = constant == Constant::U ? t : parameter;
    largest = std::max(largest, (evaluate(a, u, v) - evaluate(b, u, v)).norm());
  }
  return largest;
}

TEST(FreePoints, AreTheInnerOnesWithoutCurves) {
  const ConstrainedNet constrained = *constrain(waveNet(9, 11));
  EXPECT_EQ(constrained.free.count, 3 * 5);
  EXPECT_EQ(constrained.net.points, waveNet(9, 11).points);
}

TEST(FreePoints, LeaveCurvesOfBothDirectionsInPlaceWhereverTheyMove) {
  const ControlNet net = waveNet(13, 14);
  const std::vector<FixedCurve> curves = {
      {Constant::U, 7.0}, {Constant::U, 8.6}, {Constant::V, 6.5}, {Constant::V, 10.0}};
  const ConstrainedNet constrained = *constrain(net, curves);
  EXPECT_EQ(constrained.free.count, (7 - 2) * (8 - 2));
  const ControlNet moved = movedFreely(constrained);
  EXPECT_GT((moved.points - net.points).norm(), 1.0);
  for (const FixedCurve& curve : curves)
    EXPECT_LT(distanceAlong(curve.constant, curve.parameter, moved, net), 1e-13);
}

TEST(FreePoints, BringANetOntoGivenCurves) {
  const ControlNet net = waveNet(13, 13);
  FixedCurve curve{Constant::U, 8.0};
  curve.points = curvePoints(net, curve);
  for (int j = 3; j < 10; ++j) (*curve.points)(j, 2) += 0.2;
  const ConstrainedNet constrained = *constrain(net, {curve});
  EXPECT_LT((curvePoints(constrained.net, curve) - *curve.points).norm(), 1e-13);
}

TEST(FreePoints, GatherIsTheTransposeOfSpread) {
  const ConstrainedNet constrained = *constrain(waveNet(12, 10), {{Constant::V, 5.7}});
  const spline::Poles moves = spline::Poles::Random(constrained.free.count, 3);
  const spline::Poles slopes = spline::Poles::Random(120, 3);
  EXPECT_NEAR(constrained.free.spread(moves).cwiseProduct(slopes).sum(),
              moves.cwiseProduct(constrained.free.gather(slopes)).sum(),
              1e-12);
}

TEST(FreePoints, OfAllCurvesASpanCanHaveAreNone) {
  const std::vector<FixedCurve> curves(
      {{Constant::U, 3.5}, {Constant::U, 4.5}, {Constant::U, 5.5}, {Constant::U, 6.5}});
  const auto constrained = constrain(waveNet(7, 9), curves);
  ASSERT_TRUE(constrained);
  EXPECT_EQ(constrained->free.count, 0);
}

ErrorCode codeOf(const Result<ConstrainedNet>& result) {
  return result ? ErrorCode::Foreign : result.error().code;
}

TEST(FreePoints, RefuseCurvesThatLeaveTheRings) {
  FixedCurve curve{Constant::U, 8.0};
  curve.points = curvePoints(waveNet(13, 13), curve);
  curve.points->col(2).array() += 0.25;
  const auto refused = constrain(waveNet(13, 13), {curve});
  ASSERT_EQ(codeOf(refused), ErrorCode::CurvesContradict);
  EXPECT_NEAR(refused.error().value, 0.25, 1e-12);
}

TEST(FreePoints, RefuseCurvesThatMissEachOther) {
  FixedCurve raised{Constant::V, 7.0};
  raised.points = curvePoints(waveNet(13, 13), raised);
  raised.points->row(7)[2] += 0.3;
  EXPECT_TRUE(constrain(waveNet(13, 13), {raised}));
  EXPECT_EQ(codeOf(constrain(waveNet(13, 13), {{Constant::U, 8.0}, raised})),
            ErrorCode::CurvesContradict);
}

TEST(FreePoints, RefuseWhatTheyCannotUse) {
  EXPECT_EQ(codeOf(constrain(waveNet(6, 9))), ErrorCode::NetTooSmall);
  EXPECT_EQ(codeOf(constrain(waveNet(9, 9), {{Constant::V, 9.5}})), ErrorCode::CurveOutside);
  ControlNet broken = waveNet(9, 9);
  broken.points(4, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(codeOf(constrain(broken)), ErrorCode::NotFinite);
}

}  // namespace
}  // namespace fairing::uniform_patch
