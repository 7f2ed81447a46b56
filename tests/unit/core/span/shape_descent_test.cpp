// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/shape_descent.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>

#include "core/layout/layouts.h"
#include "core/shape_energy/mean_curvature_gradient.h"
#include "core/shape_energy/minimum_variation.h"
#include "core/shape_energy/total_curvature.h"
#include "core/solver/solve.h"
#include "core/span/span_hole.h"
#include "support/many_sided_loops.h"
#include "support/random_splines.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

constexpr double kRadius = 10.0;

// An octant of a sphere in three patches of few knots, and its thin plate.
class ShapeDescentOnASphere : public ::testing::Test {
 protected:
  ShapeDescentOnASphere()
      : loop(finished(sphereOctant(kRadius))),
        plan(layout::planLayout(loop, LayoutKind::Auto).value()),
        layout(layout::coarseLayout(plan,
                                    layout::makeLayout(plan, {.fitTolerance = 1e-5}),
                                    {3.0, 1e-5 * loop.diagonal, 24})),
        program(makeProgram(plan, layout, EnergyKind::ThinPlate).value()),
        plate(solver::solve(program).value().points),
        energy(1e-4 / loop.diagonal) {}

  [[nodiscard]] ShapeDescent descentFrom(const solver::Points& start) const {
    return {layout, energy, program, start, loop.diagonal, {0.0, 1e4}, 7};
  }
  [[nodiscard]] double offSphere(const solver::Points& points) const {
    double worst = 0.0;
    for (const auto& patch : makePatches(layout, points))
      for (int i = 0; i <= 10; ++i)
        for (int j = 0; j <= 10; ++j) {
          const auto p = patch.evaluate(patch.u.last() * i / 10.0, patch.v.last() * j / 10.0);
          worst = std::max(worst, std::abs(p.norm() - kRadius));
        }
    return worst;
  }
  // Points off by so much, rms, that still meet all that is asked.
  [[nodiscard]] solver::Points disturbed(solver::Points points, double by) const {
    const solver::Sparse freedom = solver::freedomOf(program);
    Random random{0};
    Eigen::VectorXd free(freedom.cols());
    for (double& value : free) value = randomNumber(random);
    const Eigen::VectorXd moved = freedom * free;
    const double rms = std::sqrt(moved.squaredNorm() / static_cast<double>(points.rows()));
    return points + by / rms * Eigen::Map<const solver::Points>(moved.data(), points.rows(), 3);
  }

  boundary::BoundaryLoop loop;
  layout::LayoutPlan plan;
  layout::PatchLayout layout;
  solver::QuadraticProgram program;
  solver::Points plate;
  shape_energy::MinimumVariation energy;
};

// Noise of a twentieth of the hole is a crumpled start, its energy a million times the plate's.
TEST_F(ShapeDescentOnASphere, FindsItFromThePlateAndFromNoise) {
  const double start = descentFrom(plate).energyAt(plate);
  for (const double noise : {0.0, 0.05 * loop.diagonal}) {
    solver::Points points = disturbed(plate, noise);
    ShapeDescent descent = descentFrom(plate);
    for (int steps = 0; steps < 31; ++steps) {
      const ShapeStep step = descent.step(points);
      if (!step.fell || step.length <= 1e-5 * loop.diagonal) break;
    }
    EXPECT_LT(offSphere(points), 1e-4 * loop.diagonal) << noise;
    EXPECT_LT(descent.energyAt(points), 1e-5 * start) << noise;
  }
}

// On the sphere residuals vanish: what is left after a step is the square of what was left before.
// (Minimum variation is not smooth enough there: every point is an umbilic.)
TEST_F(ShapeDescentOnASphere, ConvergesQuadratically) {
  const shape_energy::MeanCurvatureGradient smooth;
  const auto descent = [&] {
    return ShapeDescent(layout, smooth, program, plate, loop.diagonal, {0.0, 1e4}, 7);
  };
  solver::Points home = plate;
  ShapeDescent homewards = descent();
  for (int k = 0; k < 12; ++k) (void)homewards.step(home);
  const double least = homewards.energyAt(home) + homewards.anchorAt(home);
  const auto leftAfterOne = [&](double noise) {
    solver::Points points = disturbed(home, noise * loop.diagonal);
    ShapeDescent near = descent();
    EXPECT_TRUE(near.step(points).fell);
    return near.energyAt(points) + near.anchorAt(points) - least;
  };
  // The energy is the square of the distance: a quarter of the noise leaves 1 / 256 in the limit,
  // and 1 / 16 where steps only shorten the way by a factor.
  EXPECT_LT(leftAfterOne(0.00025), 0.02 * leftAfterOne(0.001));
}

TEST_F(ShapeDescentOnASphere, KeepsWhatTheConstraintsAsk) {
  solver::Points points = plate;
  ShapeDescent descent = descentFrom(plate);
  ASSERT_TRUE(descent.step(points).fell);
  const solver::Points moved = points - plate;
  const Eigen::Map<const Eigen::VectorXd> flat(moved.data(), moved.size());
  const Eigen::MatrixXd freedom = solver::freedomOf(program);
  const Eigen::VectorXd inside = freedom * freedom.colPivHouseholderQr().solve(flat);
  EXPECT_LT((inside - flat).norm(), 1e-9 * flat.norm());
}

TEST_F(ShapeDescentOnASphere, TheAnchorHoldsOnlyWhatRunsAlongTheSurface) {
  const ShapeDescent descent = descentFrom(plate);
  EXPECT_EQ(descent.anchorAt(plate), 0.0);
  // Scaled about the sphere's centre, points move along normals, nearly.
  const solver::Points outwards = 1.01 * plate;
  const solver::Points sideways =
      plate * Eigen::Matrix3d(Eigen::AngleAxisd(0.01, Eigen::Vector3d(1, 2, 3).normalized()));
  EXPECT_LT(descent.anchorAt(outwards), 1e-3 * descent.anchorAt(sideways));
}

// A hole with four sides in waves, where no energy is nought: what is left of the distance to the
// minimum after a step is its square with all second derivatives, a share without them.
template <class Energy>
double leftAfterAStep(const Energy& energy, double anchor, double noise) {
  const auto loop = finished(polygonOn(waves(), 4));
  const auto plan = layout::planLayout(loop, LayoutKind::Auto).value();
  const auto layout = layout::coarseLayout(
      plan, layout::makeLayout(plan, {.fitTolerance = 1e-5}), {2.0, 1e-5 * loop.diagonal, 24});
  const auto program = makeProgram(plan, layout, EnergyKind::ThinPlate).value();
  const solver::Points plate = solver::solve(program).value().points;
  ShapeDescent descent(layout, energy, program, plate, loop.diagonal, {0.0, anchor}, 7);
  solver::Points home = plate;
  for (int k = 0; k < 25; ++k) (void)descent.step(home);
  while (descent.newtonStep(home)) {
  }
  const double least = descent.energyAt(home) + descent.anchorAt(home);
  EXPECT_GT(least, 1e-3 * (descent.energyAt(plate) + descent.anchorAt(plate)));
  const solver::Sparse freedom = solver::freedomOf(program);
  Random random{0};
  const Eigen::VectorXd free = randomMatrix(random, freedom.cols(), 1);
  const Eigen::VectorXd moved = freedom * free;
  solver::Points points = home + noise * loop.diagonal / moved.norm() *
                                     Eigen::Map<const solver::Points>(moved.data(), home.rows(), 3);
  const double before = descent.energyAt(points) + descent.anchorAt(points) - least;
  EXPECT_TRUE(descent.newtonStep(points));
  return (descent.energyAt(points) + descent.anchorAt(points) - least) / before;
}

template <class Energy>
void expectSquares(const Energy& energy, double anchor, double noise) {
  const double far = leftAfterAStep(energy, anchor, noise);
  const double near = leftAfterAStep(energy, anchor, 0.25 * noise);
  // Both are shares of squared distances: a sixteenth in the limit, 1 if it were linear.
  EXPECT_LT(far, 0.1);
  EXPECT_LT(near, 0.15 * far);
}

TEST(ShapeDescentOnWaves, NewtonConvergesQuadraticallyWhereResidualsDoNotVanish) {
  expectSquares(shape_energy::MeanCurvatureGradient(), 1e4, 1e-3);
  expectSquares(shape_energy::MinimumVariation(1e-4), 1e4, 1e-3);
  expectSquares(shape_energy::TotalCurvature(), 1e6, 1e-3);
}

}  // namespace
}  // namespace fairing
