// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/fair_shape.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/fill/fill_hole.h"
#include "core/layout/layouts.h"
#include "support/many_sided_loops.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

std::optional<FairShape> shapeOf(const Sides& sides, EnergyKind energy) {
  const auto loop = finished(sides);
  const auto plan = layout::planLayout(loop, LayoutKind::Auto).value();
  const auto layout = layout::makeLayout(plan, {.fitTolerance = 1e-6 * loop.diagonal});
  FillOptions options;
  options.energy = energy;
  auto shape = fairShape(plan, layout, options, loop.diagonal, nullptr);
  EXPECT_TRUE(shape.has_value());
  return shape ? std::move(*shape) : std::nullopt;
}

TEST(FairShape, LowersTheEnergyOfTheShape) {
  for (const Sides& sides :
       {sphereOctant(10.0), polygonOn(waves(), 5), circleOn(waves(), 0.8), polygonOn(waves(), 4)}) {
    const auto shape = shapeOf(sides, EnergyKind::MeanCurvatureGradient);
    ASSERT_TRUE(shape.has_value());
    EXPECT_FALSE(shape->history.steps.empty());
    EXPECT_LT(shape->energy, shape->history.start);
  }
}

TEST(FairShape, GoesToTheMinimumWhereAsked) {
  const Sides sides = polygonOn(waves(), 4);
  const auto quick = shapeOf(sides, EnergyKind::MeanCurvatureGradient);
  const auto best = shapeOf(sides, EnergyKind::MeanCurvatureGradientMinimum);
  ASSERT_TRUE(quick && best);
  EXPECT_EQ(quick->history.end, solver::ShapeEnd::Quick);
  EXPECT_EQ(best->history.end, solver::ShapeEnd::Converged);
  EXPECT_GE(best->history.steps.size(), quick->history.steps.size());
}

FillResult filled(const Sides& sides, EnergyKind energy) {
  FillOptions options;
  options.energy = energy;
  return fillHole(finished(sides), options).value();
}

// The steps end on the knots of the result: what they reached is what is measured on it, and less
// than what a few steps and a fit leave.
TEST(FairShape, TheResultHasTheEnergyThatTheStepsReached) {
  for (const Sides& sides : {polygonOn(waves(), 4), polygonOn(waves(), 5)}) {
    const FillResult best = filled(sides, EnergyKind::MeanCurvatureGradientMinimum);
    const double value = best.report.fairness.meanCurvatureGradient;
    EXPECT_EQ(best.summary.shape.steps.back().level, 1);
    EXPECT_NEAR(value / best.summary.shape.steps.back().energy, 1.0, 0.02);
    EXPECT_LT(
        value,
        filled(sides, EnergyKind::MeanCurvatureGradient).report.fairness.meanCurvatureGradient);
  }
}

TEST(FairShape, GoesOnOnFinerKnotsOnlyToTheMinimum) {
  const Sides sides = polygonOn(waves(), 4);
  const auto loop = finished(sides);
  const auto plan = layout::planLayout(loop, LayoutKind::Auto).value();
  for (const EnergyKind energy :
       {EnergyKind::MeanCurvatureGradient, EnergyKind::MeanCurvatureGradientMinimum}) {
    FillOptions options;
    options.energy = energy;
    auto shape = shapeOf(sides, energy);
    ASSERT_TRUE(shape.has_value());
    const auto further =
        fairFurther(plan, shape->layout, shape->patches, options, loop.diagonal, nullptr, *shape);
    ASSERT_TRUE(further.has_value());
    EXPECT_EQ(*further, energy == EnergyKind::MeanCurvatureGradientMinimum);
  }
}

TEST(FairShape, FallsFromStepToStepOnALevel) {
  for (const EnergyKind energy : {EnergyKind::MinimumVariation, EnergyKind::TotalCurvature}) {
    const auto shape = shapeOf(polygonOn(waves(), 5), energy);
    ASSERT_TRUE(shape.has_value());
    const auto& steps = shape->history.steps;
    for (std::size_t k = 1; k < steps.size(); ++k)
      if (steps[k].level == steps[k - 1].level) {
        EXPECT_LT(steps[k].energy + steps[k].anchor, steps[k - 1].energy + steps[k - 1].anchor);
      }
    EXPECT_EQ(shape->energy, steps.back().energy);
  }
}

TEST(FairShape, IsNoMatterOfQuadraticEnergies) {
  EXPECT_FALSE(shapeOf(sphereOctant(10.0), EnergyKind::ThinPlate).has_value());
  EXPECT_FALSE(shapeOf(sphereOctant(10.0), EnergyKind::Membrane).has_value());
  EXPECT_FALSE(shapeOf(sphereOctant(10.0), EnergyKind::Triharmonic).has_value());
}

TEST(FairShape, StopsWhereItIsCancelled) {
  Progress abort;
  abort.requestAbort();
  const auto loop = finished(sphereOctant(10.0));
  const auto plan = layout::planLayout(loop, LayoutKind::Auto).value();
  const auto layout = layout::makeLayout(plan, {.fitTolerance = 1e-5});
  const auto shape = fairShape(plan, layout, {}, loop.diagonal, &abort);
  ASSERT_FALSE(shape.has_value());
  EXPECT_EQ(shape.error().code, ErrorCode::Cancelled);
}

TEST(FairShape, KeepsTheBestSoFarWhereThatIsAsked) {
  Progress finish;
  finish.requestFinish();
  const auto loop = finished(sphereOctant(10.0));
  FillOptions options;
  options.energy = EnergyKind::MinimumVariation;
  const auto fill = fillHole(loop, options, &finish);
  ASSERT_TRUE(fill.has_value());
  EXPECT_TRUE(fill->report.withinTolerance);
  EXPECT_EQ(fill->summary.shape.end, solver::ShapeEnd::Stopped);
  EXPECT_TRUE(fill->summary.shape.steps.empty());
  ASSERT_FALSE(fill->report.notes.empty());
  EXPECT_EQ(fill->report.notes.back().code, analysis::NoteCode::ShapeStopped);
}

// Lobatto's points lie on the borders, too; the shape is the same but for the rule's own error.
TEST(FairShape, IsTheSameWithEitherQuadrature) {
  const Sides sides = polygonOn(waves(), 4);
  FillOptions gauss, lobatto;
  gauss.energy = lobatto.energy = EnergyKind::MeanCurvatureGradientMinimum;
  lobatto.quadrature = {0, spline::QuadratureFamily::Lobatto};
  const auto one = fillHole(finished(sides), gauss), other = fillHole(finished(sides), lobatto);
  ASSERT_TRUE(one && other);
  EXPECT_NE(one->summary.shape.steps.back().energy, other->summary.shape.steps.back().energy);
  EXPECT_NEAR(
      other->report.fairness.meanCurvatureGradient / one->report.fairness.meanCurvatureGradient,
      1.0,
      1e-2);
}

TEST(FairShape, ReproducesASphere) {
  constexpr double kRadius = 10.0;
  const auto loop = finished(sphereOctant(kRadius));
  const auto fill = fillHole(loop, {});
  ASSERT_TRUE(fill.has_value());
  double worst = 0.0;
  for (const auto& patch : fill->patches)
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 20; ++j) {
        const auto point = patch.evaluate(patch.u.last() * i / 20.0, patch.v.last() * j / 20.0);
        worst = std::max(worst, std::abs(point.norm() - kRadius));
      }
  EXPECT_LT(worst, 1e-5 * loop.diagonal);
}

}  // namespace
}  // namespace fairing
