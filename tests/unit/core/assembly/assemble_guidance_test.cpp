// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/assemble_guidance.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/quadratic_forms.h"
#include "support/random_splines.h"

namespace fairing::assembly {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of quadratic forms
using Eigen::Vector3d;
using Eigen::VectorXd;
using energy::Guidance;
using spline::BsplineSurface;
using spline::KnotVector;

BsplineSurface somePatch(unsigned seed) {
  Random random{seed};
  const KnotVector u = randomKnots(random, 3, 2), v = randomKnots(random, 4, 2);
  return randomSurface(random, u.mapped(0.0, 1.25), v.mapped(0.0, 0.8));
}

// Splines over the unit square on knots that are not the patch's.
Guidance continuousGuidance(double lambda, double gamma) {
  Random random{7};
  const KnotVector n = randomKnots(random, 2, 2), s = randomKnots(random, 5, 3);
  Guidance guidance;
  guidance.lambda = lambda;
  guidance.gamma = gamma;
  guidance.continuous = {randomSurface(random, n, n, 1.0), randomSurface(random, s, s)};
  return guidance;
}

// The oracle: eight Gauss points on a mesh that holds every knot of patch and guide.
double continuousEnergy(const BsplineSurface& patch, const Guidance& g) {
  const BsplineSurface& normals = g.continuous->normals;
  const BsplineSurface& reference = *g.continuous->reference;
  BsplineSurface fine = patch;
  const auto split = [](KnotVector knots, const KnotVector& guide) {
    for (const double b : guide.mapped(knots.first(), knots.last()).breaks())
      if (b > knots.first() && b < knots.last()) knots = knots.withKnot(b);
    return knots;
  };
  fine.u = split(split(fine.u, normals.u), reference.u);
  fine.v = split(split(fine.v, normals.v), reference.v);
  return 0.5 * integral(fine, 8, [&](double u, double v) {
           const double s = u / patch.u.last(), t = v / patch.v.last();
           return guidedIntegrand(patch.jet(u, v),
                                  normals.evaluate(s, t),
                                  reference.evaluate(s, t),
                                  g.lambda,
                                  g.gamma);
         });
}

Guidance sampled(double lambda, double gamma) {
  Random random{8};
  return discreteGuidance(random, lambda, gamma);
}

using Oracle = double (*)(const BsplineSurface&, const Guidance&);

struct Case {
  const char* name;
  Guidance guidance;
  Oracle energy;
};

class AssembleGuidance : public ::testing::TestWithParam<Case> {
 protected:
  BsplineSurface patch_ = somePatch(0);
  GuidanceSystem system_ =
      assembleGuidance(freePatch(patch_.u, patch_.v), GetParam().guidance, {patch_});
  VectorXd x_ = flattened(patch_.poles);
};

TEST_P(AssembleGuidance, IsTheEnergyOfTheSurface) {
  const double expected = GetParam().energy(patch_, GetParam().guidance);
  const double got = 0.5 * x_.dot(system_.coupled() * x_) - system_.load.dot(x_) + system_.constant;
  EXPECT_NEAR(got, expected, 1e-12 * (1.0 + expected));
}

TEST_P(AssembleGuidance, GradientIsThatOfTheEnergy) {
  const auto energyAt = [&](const VectorXd& x) {
    return GetParam().energy({patch_.u, patch_.v, unflattened(x)}, GetParam().guidance);
  };
  const VectorXd expected = quadraticGradient(energyAt, x_);
  const VectorXd got = system_.coupled() * x_ - system_.load;
  EXPECT_THAT(got, IsNear(expected, 1e-11 * (1.0 + expected.norm())));
}

TEST_P(AssembleGuidance, MatrixIsSymmetric) {
  const Eigen::MatrixXd k = system_.coupled();
  EXPECT_LT((k - k.transpose()).norm(), 1e-14 * k.norm());
}

INSTANTIATE_TEST_SUITE_P(
    Forms,
    AssembleGuidance,
    ::testing::Values(Case{"ContinuousLambda", continuousGuidance(2.5, 0.0), continuousEnergy},
                      Case{"ContinuousGamma", continuousGuidance(0.0, 1.5), continuousEnergy},
                      Case{"ContinuousBoth", continuousGuidance(2.5, 1.5), continuousEnergy},
                      Case{"DiscreteLambda", sampled(2.5, 0.0), discreteEnergy},
                      Case{"DiscreteGamma", sampled(0.0, 1.5), discreteEnergy},
                      Case{"DiscreteBoth", sampled(2.5, 1.5), discreteEnergy}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(AssembleGuidance, WithoutGuidanceNothingIsAdded) {
  const BsplineSurface patch = somePatch(1);
  const GuidanceSystem system = assembleGuidance(freePatch(patch.u, patch.v), {}, {patch});
  EXPECT_EQ(system.coupled().norm(), 0.0);
  EXPECT_EQ(system.load.norm(), 0.0);
  EXPECT_EQ(system.constant, 0.0);
}

TEST(AssembleGuidance, AHandleActsOnlyWithinItsRadius) {
  const BsplineSurface patch = somePatch(2);
  Guidance guidance;
  guidance.lambda = 1.0;
  guidance.handles = {{Vector3d(50.0, 0.0, 0.0), Vector3d::UnitZ(), 1.0, 5.0}};
  const auto layout = freePatch(patch.u, patch.v);
  EXPECT_EQ(assembleGuidance(layout, guidance, {patch}).coupled().norm(), 0.0);
  guidance.handles[0].point = patch.evaluate(0.6, 0.4);
  guidance.handles[0].radius = 0.5;
  EXPECT_GT(assembleGuidance(layout, guidance, {patch}).coupled().norm(), 0.0);
}

TEST(AssembleGuidance, ADenseGridOfUnitWeightsTendsToTheIntegral) {
  // The same field both ways: a rectangle rule against exact quadrature, so first order in 1/n.
  const BsplineSurface patch = somePatch(3);
  const Guidance exact = continuousGuidance(1.0, 1.0);
  const auto value = [&](const Guidance& g) {
    const GuidanceSystem s = assembleGuidance(freePatch(patch.u, patch.v), g, {patch});
    const VectorXd x = flattened(patch.poles);
    return 0.5 * x.dot(s.coupled() * x) - s.load.dot(x) + s.constant;
  };
  const auto sampled = [&](int n) {
    energy::DiscreteGuidance grid;
    grid.n = grid.m = n;
    const Eigen::Index count = (n + 1) * (n + 1);
    grid.normals.resize(count, 3);
    grid.points.resize(count, 3);
    grid.lambda = grid.gamma = VectorXd::Ones(count);
    for (int k = 0; k < count; ++k) {
      const double s = static_cast<double>(k / (n + 1)) / n;
      const double t = static_cast<double>(k % (n + 1)) / n;
      grid.normals.row(k) = exact.continuous->normals.evaluate(s, t).transpose();
      grid.points.row(k) = exact.continuous->reference->evaluate(s, t).transpose();
    }
    Guidance guidance;
    guidance.lambda = guidance.gamma = 1.0;
    guidance.discrete = grid;
    return value(guidance);
  };
  const double limit = value(exact);
  const double coarse = std::abs(sampled(10) - limit), fine = std::abs(sampled(40) - limit);
  EXPECT_LT(fine, 0.35 * coarse);  // a quarter, and a margin for the second order
  EXPECT_LT(fine, 0.1 * limit);
}

}  // namespace
}  // namespace fairing::assembly
