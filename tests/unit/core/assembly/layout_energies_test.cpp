// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <cmath>

#include "core/assembly/assemble_energy.h"
#include "core/assembly/assemble_guidance.h"
#include "core/assembly/assemble_shape_energy.h"
#include "core/layout/layouts.h"
#include "core/layout/strip.h"
#include "core/shape_energy/mean_curvature_gradient.h"
#include "core/shape_energy/minimum_variation.h"
#include "core/shape_energy/total_curvature.h"
#include "core/solver/solve.h"
#include "core/span/span_hole.h"
#include "support/many_sided_loops.h"
#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/quadratic_forms.h"
#include "support/random_splines.h"

// The energies over the shared points of whole layouts. Along any line of points a quadratic energy
// is a parabola: its slope and its curvature by differences of any step, here 1, are exact.

namespace fairing::assembly {
namespace {

using namespace ::fairing::testing;  // NOLINT: loops, random splines, quadratic forms
using Eigen::Vector2d;
using Eigen::VectorXd;
using layout::LayoutPlan;
using layout::PatchLayout;

constexpr int kLines = 4;        // of points, in random directions
constexpr double kRough = 0.03;  // off a fair surface

LayoutPlan planOf(Sides sides, LayoutKind kind) {
  return layout::planLayout(finished(std::move(sides)), kind).value();
}

boundary::SideChain chain(
    const KnownSurface& surface, const Vector2d& from, const Vector2d& to, int index, bool closed) {
  return {{sideOn(surface, line(from, to), index)}, closed};
}

LayoutPlan openStrip() {
  return layout::stripPlan(boundary::pairChains(chain(waves(), {0, 0}, {1, 0}, 0, false),
                                                chain(waves(), {1, 1}, {0, 1}, 1, false))
                               .value())
      .value();
}

LayoutPlan closedStrip() {
  const double round = 2.0 * M_PI;
  return layout::stripPlan(
             boundary::pairChains(chain(cylinder(1.0), {0, 0}, {round, 0}, 0, true),
                                  chain(cylinder(1.0), {round, 1.5}, {0, 1.5}, 1, true))
                 .value())
      .value();
}

struct Case {
  const char* name;
  std::function<LayoutPlan()> plan;
  std::size_t patches;
};

class EnergiesOf : public ::testing::TestWithParam<Case> {
 protected:
  EnergiesOf() {
    const LayoutPlan plan = GetParam().plan();
    layout_ = layout::coarseLayout(plan,
                                   layout::makeLayout(plan, {.fitTolerance = 1e-4}),
                                   {.density = 2.0, .fitTolerance = 0.01});
    const auto program = makeProgram(plan, layout_, EnergyKind::ThinPlate);
    fair_ = solver::solve(program.value()).value().points;
    points_ = fair_ + kRough * direction();
  }

  solver::Points direction() { return randomMatrix(random_, layout_.pointCount, 3); }
  [[nodiscard]] Patches at(const solver::Points& points) const {
    return makePatches(layout_, points);
  }

  // Value, slopes and curvatures of  1/2 x' H x - g . x + c  against an energy's own.
  template <class Energy>
  void expectParabolas(const solver::Sparse& hessian,
                       const VectorXd& load,
                       double constant,
                       const Energy& energyOf) {
    const VectorXd x = solver::flat(points_);
    const double value = energyOf(points_), size = 1.0 + value;
    EXPECT_NEAR(0.5 * x.dot(hessian * x) - load.dot(x) + constant, value, 1e-12 * size);
    EXPECT_LT((hessian - solver::Sparse(hessian.transpose())).norm(), 1e-14 * hessian.norm());
    for (int k = 0; k < kLines; ++k) {
      const solver::Points step = direction();
      const VectorXd d = solver::flat(step);
      const double above = energyOf(points_ + step), below = energyOf(points_ - step);
      const double scale = size + above + below;
      EXPECT_NEAR(d.dot(hessian * x - load), 0.5 * (above - below), 1e-12 * scale);
      EXPECT_NEAR(d.dot(hessian * d), above - 2.0 * value + below, 1e-12 * scale);
    }
  }

  Random random_{3};
  PatchLayout layout_;
  solver::Points fair_, points_;
};

TEST_P(EnergiesOf, QuadraticEnergiesAreThoseOfThePatches) {
  ASSERT_EQ(layout_.patches.size(), GetParam().patches);
  const VectorXd none = VectorXd::Zero(3 * layout_.pointCount);
  const auto expect = [&](const energy::EnergyTerms& terms, const auto& ofPatch) {
    expectParabolas(solver::threefold(assembleEnergy(layout_, terms)),
                    none,
                    0.0,
                    [&](const solver::Points& points) {
                      double sum = 0.0;
                      for (const auto& patch : at(points)) sum += ofPatch(patch);
                      return sum;
                    });
  };
  expect(energy::membrane(), membraneEnergy);
  expect(energy::thinPlate(), thinPlateEnergy);
}

TEST_P(EnergiesOf, GuidanceIsThatOfThePatches) {
  const energy::Guidance guidance = discreteGuidance(random_, 2.5, 1.5);
  const GuidanceSystem system = assembleGuidance(layout_, guidance, at(points_));
  expectParabolas(
      system.coupled(), system.load, system.constant, [&](const solver::Points& points) {
        double sum = 0.0;
        for (const auto& patch : at(points)) sum += discreteEnergy(patch, guidance);
        return sum;
      });
}

TEST_P(EnergiesOf, GradientsOfShapeEnergiesAreThoseOfDifferences) {
  const shape_energy::MeanCurvatureGradient gradient;
  const shape_energy::MinimumVariation variation(1e-4);
  const shape_energy::TotalCurvature total;
  for (const shape_energy::ShapeEnergy* energy :
       std::initializer_list<const shape_energy::ShapeEnergy*>{&gradient, &variation, &total}) {
    VectorXd slopes = VectorXd::Zero(3 * layout_.pointCount);
    for (const ShapeElement& e : assembleShapeEnergy(layout_, at(fair_), *energy))
      for (std::size_t k = 0; k < e.points.size(); ++k)
        slopes.segment<3>(3 * e.points[k]) +=
            e.gradient.segment<3>(3 * static_cast<Eigen::Index>(k));
    for (int k = 0; k < kLines; ++k) {
      const solver::Points step = direction();
      const double expected = derivative(
          [&](double t) { return shapeEnergyOf(at(fair_ + t * step), *energy); }, 0.0, 1e-6);
      const VectorXd d = solver::flat(step);
      EXPECT_NEAR(slopes.dot(d), expected, 1e-5 * slopes.norm() * d.norm());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Layouts,
    EnergiesOf,
    ::testing::Values(
        Case{"Quad", [] { return planOf(sidesOf(waves(), unitSquare()), LayoutKind::Quad); }, 1},
        Case{"Star", [] { return planOf(polygonOn(waves(), 5), LayoutKind::Star); }, 5},
        Case{"OGrid", [] { return planOf(circleOn(waves(), 0.8), LayoutKind::OGrid); }, 5},
        Case{"OpenStrip", openStrip, 1},
        Case{"ClosedStrip", closedStrip, 1}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace fairing::assembly
