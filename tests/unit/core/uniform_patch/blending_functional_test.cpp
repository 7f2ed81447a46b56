// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/blending_functional.h"

#include <gtest/gtest.h>

#include "support/known_nets.h"
#include "support/numerical_derivative.h"

namespace fairing::uniform_patch {
namespace {

using namespace ::fairing::testing;  // NOLINT: nets, derivatives

constexpr double kWeight = 0.3;

class BlendingFunctionalTest : public ::testing::Test {
 protected:
  // a curve, so that some control points move with several free ones
  ConstrainedNet constrained_ = *constrain(waveNet(9, 12), {{FixedCurve::Constant::V, 6.6}});
  BlendingFunctional functional_{constrained_.net, constrained_.free, kWeight, 4, 1};

  [[nodiscard]] spline::Poles moved(const Eigen::VectorXd& direction, double by) const {
    const Eigen::VectorXd moves = by * direction;
    return constrained_.net.points + constrained_.free.spread(Eigen::Map<const spline::Poles>(
                                         moves.data(), constrained_.free.count, 3));
  }
  [[nodiscard]] double valueAt(const spline::Poles& points) const {
    const BlendingValue<double> value = functional_.value(points);
    return value.shape + kWeight * value.parametrisation;
  }
};

TEST_F(BlendingFunctionalTest, HasTheDerivativesOfDifferences) {
  const BlendingModel model = functional_.model(constrained_.net.points);
  EXPECT_NEAR(model.value, valueAt(constrained_.net.points), 1e-12 * model.value);
  EXPECT_EQ(model.gradient, functional_.gradient(constrained_.net.points));
  std::srand(1);
  for (int k = 0; k < 5; ++k) {
    const Eigen::VectorXd direction = Eigen::VectorXd::Random(model.gradient.size()).normalized();
    const double slope =
        derivative([&](double by) { return valueAt(moved(direction, by)); }, 0.0, 1e-4);
    EXPECT_NEAR(model.gradient.dot(direction), slope, 1e-6 * model.gradient.norm());
    const Eigen::VectorXd bend = derivative(
        [&](double by) -> Eigen::VectorXd { return functional_.gradient(moved(direction, by)); },
        0.0,
        1e-4);
    EXPECT_LT((model.hessian * direction - bend).norm(), 1e-6 * bend.norm());
  }
}

TEST_F(BlendingFunctionalTest, DoesNotDependOnTheNumberOfThreads) {
  const BlendingFunctional parallel(constrained_.net, constrained_.free, kWeight, 4, 3);
  const BlendingModel one = functional_.model(constrained_.net.points),
                      three = parallel.model(constrained_.net.points);
  EXPECT_EQ(one.value, three.value);
  EXPECT_EQ(one.gradient, three.gradient);
  const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(one.hessian.size(), one.hessian.size());
  EXPECT_EQ(one.hessian * all, three.hessian * all);
}

}  // namespace
}  // namespace fairing::uniform_patch
