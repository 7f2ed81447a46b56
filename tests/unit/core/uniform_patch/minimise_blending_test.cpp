// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/minimise_blending.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/uniform_patch/damped_step.h"
#include "core/uniform_patch/triharmonic.h"
#include "support/known_nets.h"

namespace fairing::uniform_patch {
namespace {

using namespace ::fairing::testing;  // NOLINT: nets

ConstrainedNet triharmonicStart(const ControlNet& rings,
                                const std::vector<FixedCurve>& curves = {}) {
  ConstrainedNet start = *constrain(rings, curves);
  start.net = *triharmonicNet(start);
  return start;
}

BlendingResult minimised(const ControlNet& rings, const BlendingOptions& options = {}) {
  return *minimiseBlending(triharmonicStart(rings), options);
}

double largestDifference(const ControlNet& a, const ControlNet& b) {
  return (a.points - b.points).cwiseAbs().maxCoeff();
}

TEST(MinimiseBlending, NeverRaisesTheFunctional) {
  ConstrainedNet start = *constrain(disturbed(waveNet(14, 12), 0.02));
  const BlendingResult result = *minimiseBlending(start);
  EXPECT_EQ(result.report.outcome, BlendingOutcome::Converged);
  double before = std::numeric_limits<double>::infinity();
  for (const BlendingStep& step : result.report.steps) {
    EXPECT_LT(step.value, before * (1.0 + 1e-12));
    before = step.value;
  }
  EXPECT_GT(result.report.steps.front().damping, 0.0);  // an indefinite beginning
  EXPECT_EQ(result.report.steps.back().damping, 0.0);
}

TEST(MinimiseBlending, EndsAtOneMinimumWhereverItStarts) {
  const ControlNet rings = waveNet(14, 12);
  const BlendingResult a = minimised(rings), b = *minimiseBlending(*constrain(coonsNet(rings)));
  EXPECT_NEAR(a.report.value(), b.report.value(), 1e-9 * a.report.value());
  EXPECT_LT(largestDifference(a.net, b.net), 1e-4);
  for (unsigned seed = 0; seed < 3; ++seed)
    EXPECT_GT(measureBlending(disturbed(a.net, 1e-3, seed), a.report.c).value(), a.report.value());
}

// The slope that a Newton step leaves when it starts this far from the minimum, in a wide bump.
double slopeAfterNewton(const ConstrainedNet& minimum, double distance) {
  const double c = parametrisationFactor(minimum.net, 1e-3);
  const BlendingFunctional functional(minimum.net, minimum.free, c, 4, 1);
  ControlNet net = minimum.net;
  for (int i = 0; i < net.rows; ++i)
    for (int j = 0; j < net.columns; ++j)
      if (net.isInner(i, j))
        net.points.row(net.index(i, j)) +=
            distance * std::sin(std::numbers::pi * (i - 2) / (net.rows - 5)) *
            std::sin(std::numbers::pi * (j - 2) / (net.columns - 5)) *
            Eigen::RowVector3d(0.3, -0.2, 1.0);
  const BlendingModel model = functional.model(net.points);
  const auto step = DampedSearch(minimum, functional, c).best(net.points, model);
  EXPECT_EQ(step->damping, 0.0);
  return functional.gradient(step->points).norm();
}

TEST(MinimiseBlending, ConvergesQuadratically) {
  ConstrainedNet minimum = triharmonicStart(waveNet(14, 12));
  minimum.net = minimiseBlending(minimum)->net;
  const double far = slopeAfterNewton(minimum, 1e-3), near = slopeAfterNewton(minimum, 5e-4);
  EXPECT_NEAR(std::log2(far / near), 2.0, 0.15);
}

TEST(MinimiseBlending, KeepsRingsAndCurvesExactly) {
  const ControlNet rings = waveNet(14, 14);
  const ConstrainedNet start = triharmonicStart(rings, {{FixedCurve::Constant::U, 8.4}});
  const BlendingResult result = *minimiseBlending(start);
  EXPECT_EQ(result.report.outcome, BlendingOutcome::Converged);
  for (double v = 3.0; v <= 14.0; v += 0.3)
    EXPECT_LT((evaluate(result.net, 8.4, v) - evaluate(rings, 8.4, v)).norm(), 1e-12);
  for (const double v : {3.0, 14.0})
    EXPECT_EQ(evaluate(result.net, 6.2, v, 0, 2), evaluate(rings, 6.2, v, 0, 2));
  EXPECT_GT(result.report.value(), minimised(rings).report.value());
}

TEST(MinimiseBlending, MovesWithRigidMotionsAndScale) {
  const ControlNet rings = waveNet(12, 12);
  const BlendingResult here = minimised(rings);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  const double scale = 40.0;
  const auto moved = [&](ControlNet net) {
    net.points =
        (scale * net.points * turn.transpose()).rowwise() + Eigen::RowVector3d(100.0, -50.0, 7.0);
    return net;
  };
  const BlendingResult there = minimised(moved(rings));
  EXPECT_LT(largestDifference(moved(here.net), there.net), 1e-5 * scale);
  EXPECT_NEAR(
      there.report.value() * scale * scale, here.report.value(), 1e-9 * here.report.value());
}

// Rings of a sphere. Third derivatives of cubics are constant over a span, so that what is left of
// |grad H|^2 falls with the square of the spans.
TEST(MinimiseBlending, MakesSpheres) {
  const auto sphere = [](int n) {
    return netOf(n, n, [n](double u, double v) {
      // control points a little outside, so that the patch lies on the sphere
      const double h = 2.0 / (n - 3), lift = 1.0 + 0.49 * h * h / 6.0;
      return Eigen::Vector3d(Eigen::AngleAxisd(0.7 * u, Eigen::Vector3d::UnitY()) *
                             Eigen::AngleAxisd(-0.7 * v, Eigen::Vector3d::UnitX()) *
                             Eigen::Vector3d(0.0, 0.0, lift * lift));
    });
  };
  const BlendingResult coarse = minimised(sphere(10)), fine = minimised(sphere(17));
  EXPECT_LT(fine.report.shape, 1e-3);
  EXPECT_LT(fine.report.shape, 0.3 * coarse.report.shape);
  EXPECT_NEAR(evaluate(fine.net, 10.0, 10.0).norm(), 1.0, 1e-4);
}

TEST(MinimiseBlending, LeavesAPlaneAlone) {
  const ControlNet plane =
      netOf(10, 10, [](double u, double v) { return Eigen::Vector3d(u, v, 0.2 * u); });
  const BlendingResult result = minimised(plane);
  EXPECT_EQ(result.report.outcome, BlendingOutcome::Converged);
  EXPECT_LT(result.report.value(), 1e-20);
  EXPECT_LT(largestDifference(result.net, plane), 1e-12);
}

TEST(MinimiseBlending, TellsWhereTheStartIsSingular) {
  ControlNet net = waveNet(11, 11);  // a whole span has one control point
  for (int i = 3; i < 8; ++i)
    for (int j = 3; j < 8; ++j) net.points.row(net.index(i, j)) << 0.1, 0.2, 0.3;
  const auto refused = minimiseBlending(*constrain(net));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::NormalVanishes);
  ASSERT_TRUE(refused.error().where);
  EXPECT_LT((*refused.error().where - Eigen::Vector3d(0.1, 0.2, 0.3)).norm(), 0.5);
}

TEST(MinimiseBlending, RefusesANegativeWeight) {
  const auto refused = minimiseBlending(*constrain(waveNet(9, 9)), {.weight = -1.0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::WeightNegative);
}

// Without the parametrisation's term nothing says where on the surface a control point lies.
TEST(MinimiseBlending, EndsWithoutStabilisationAndSaysHow) {
  const BlendingResult some = minimised(waveNet(12, 12), {.weight = 0.0, .stepLimit = 4});
  EXPECT_EQ(some.report.outcome, BlendingOutcome::StepLimit);
  EXPECT_EQ(some.report.steps.size(), 4u);
  EXPECT_EQ(some.report.c, 0.0);
  EXPECT_LT(some.report.shape, minimised(waveNet(12, 12)).report.shape);
}

TEST(MinimiseBlending, ReturnsTheBestNetWhenCancelled) {
  Progress progress;
  progress.requestAbort();
  const ConstrainedNet start = triharmonicStart(waveNet(9, 9));
  const BlendingResult result = *minimiseBlending(start, {}, &progress);
  EXPECT_EQ(result.report.outcome, BlendingOutcome::Cancelled);
  EXPECT_EQ(result.net.points, start.net.points);
}

}  // namespace
}  // namespace fairing::uniform_patch
