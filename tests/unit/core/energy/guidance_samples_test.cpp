// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/guidance_samples.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/random_splines.h"

namespace fairing::energy {
namespace {

using namespace ::fairing::testing;  // NOLINT: random splines
using Eigen::Vector3d;
using spline::BsplineSurface;
using spline::KnotVector;

// The rectangle [0, 1.5] x [0, 0.8] in the plane.
BsplineSurface flatPatch() {
  Random random{0};
  const KnotVector u = randomKnots(random, 4, 3).mapped(0.0, 1.5);
  const KnotVector v = randomKnots(random, 3, 2).mapped(0.0, 0.8);
  return interpolated([](double x, double y) { return Vector3d(x, y, 0.0); }, u, v);
}

std::vector<WeightedSample> samplesOn(const BsplineSurface& patch, const Guidance& guidance) {
  return guidanceSamples(guidance, NormalFeet(guidance, {patch}), patch.u, patch.v, patch);
}

double weightOf(const std::vector<WeightedSample>& samples) {
  double sum = 0.0;
  for (const WeightedSample& s : samples) sum += s.weight;
  return sum;
}

TEST(GuidanceSamples, OfTheContinuousFormWeighTheDomainsArea) {
  const BsplineSurface patch = flatPatch();
  Guidance guidance;
  guidance.continuous = {patch, patch};
  EXPECT_NEAR(weightOf(samplesOn(patch, guidance)), 1.2, 1e-13);
}

TEST(GuidanceSamples, OfTheDiscreteFormShareTheDomainsArea) {
  const BsplineSurface patch = flatPatch();
  DiscreteGuidance grid{2,
                        3,
                        spline::Poles::Zero(12, 3),
                        spline::Poles::Zero(12, 3),
                        Eigen::VectorXd::Ones(12),
                        Eigen::VectorXd::Ones(12)};
  Guidance guidance;
  guidance.discrete = grid;
  const auto samples = samplesOn(patch, guidance);
  ASSERT_EQ(samples.size(), 12U);
  EXPECT_NEAR(weightOf(samples), 1.2, 1e-13);
  EXPECT_NEAR(samples[5].u, 0.75, 1e-15);  // row 1 * 4 + 1: (1/2, 1/3)
  EXPECT_NEAR(samples[5].v, 0.8 / 3.0, 1e-15);
}

TEST(GuidanceSamples, MultiplyTheGlobalWeightsIn) {
  const BsplineSurface patch = flatPatch();
  Guidance guidance;
  guidance.lambda = 2.0;
  guidance.gamma = 3.0;
  guidance.reference = [](const Vector3d& near) {
    return GuidanceSample{Vector3d::UnitZ(), near, 0.5, 0.25};
  };
  for (const WeightedSample& s : samplesOn(patch, guidance)) {
    EXPECT_EQ(s.guide.lambda, 1.0);
    EXPECT_EQ(s.guide.gamma, 0.75);
  }
}

TEST(GuidanceSamples, LookTheReferenceUpNearTheCurrentShape) {
  const BsplineSurface patch = flatPatch();
  Guidance guidance;
  guidance.gamma = 1.0;
  guidance.reference = [](const Vector3d& near) {
    return GuidanceSample{Vector3d::UnitZ(), near, 1.0, 1.0};
  };
  for (const WeightedSample& s : samplesOn(patch, guidance))
    EXPECT_LT((s.guide.point - Vector3d(s.u, s.v, 0.0)).norm(), 1e-13);
}

TEST(GuidanceSamples, OfAHandleFadeWithTheDistance) {
  const BsplineSurface patch = flatPatch();
  const Vector3d at(0.7, 0.4, 0.0);
  Guidance guidance;
  guidance.lambda = 1.0;
  guidance.handles = {{at, Vector3d(0.0, 0.0, 2.0), 3.0, 0.3}};
  const auto samples = samplesOn(patch, guidance);
  ASSERT_FALSE(samples.empty());
  bool isReached = false;
  for (const WeightedSample& s : samples) {
    if (s.guide.lambda == 0.0) continue;
    isReached = true;
    const double distance = (Vector3d(s.u, s.v, 0.0) - at).norm();
    EXPECT_LT(distance, 0.3);
    EXPECT_LE(s.guide.lambda, 3.0);
    EXPECT_GT(s.guide.lambda, 0.0);
    // 3 (1 - (r / 0.3)^2)^2
    EXPECT_NEAR(s.guide.lambda, 3.0 * std::pow(1.0 - distance * distance / 0.09, 2), 1e-12);
    EXPECT_NEAR(s.guide.normal.norm(), 1.0, 1e-15);
    EXPECT_EQ(s.guide.gamma, 0.0);
  }
  EXPECT_TRUE(isReached);
}

}  // namespace
}  // namespace fairing::energy
