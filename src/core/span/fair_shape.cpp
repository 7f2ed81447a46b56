// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/fair_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/assembly/assemble_shape_energy.h"
#include "core/layout/layouts.h"
#include "core/shape_energy/mean_curvature_gradient.h"
#include "core/shape_energy/minimum_variation.h"
#include "core/shape_energy/total_curvature.h"
#include "core/solver/solve.h"
#include "core/span/shape_descent.h"

namespace fairing {
namespace {

// How few the knots are, how far the steps go, and what holds the parametrisation.
struct Effort {
  double fitShare;  // of the diagonal: how closely the sides are followed
  int mostPolesAlong;
  int steps;            // most, on each level
  double worthAStep;    // share of the energy that a step has to take away
  double settled;       // share of the diagonal: smaller steps are the last
  bool toTheEnd;        // a second time on finer knots
  int mostPointsOfFit;  // if these are the fit's
  ShapeHold hold;
  spline::QuadratureRule quadrature;
};

// Spans over a length as long as the hole is wide. Patches that meet in an inner vertex need more
// (an octant of a sphere: 4e-5 of the diagonal off at 2, 5e-6 at 3), and so does what guidance
// shapes.
constexpr double kDensity = 2.0, kHighDensity = 3.0;
constexpr int kSteps = 2;
// A strip's start is farther from its end: nothing holds its middle.
constexpr int kStepsOfStrips = 8, kStepsOfJunctions = 16;
// As an integral; 1e4 lets the parametrisation drift: one round more on stars, and waves farther
// off.
constexpr double kPinning = 1e5;
// Only an anchored parametrisation has a minimum. More of it costs shape (a patch of a torus keeps
// 1e-7 of the plate's energy with 1e4, 3e-6 with 1e5), less of it costs steps. Second order: with
// less, the first row of control points slides onto the border, where a crease costs nothing.
constexpr double kAnchorOfThirdOrder = 1e4, kAnchorOfSecondOrder = 1e6;
// On the next level: less where spans are halved, for it starts closer to its end; more on the
// knots of a fit, which are dense next to the corners and would drift there (with 1 the plate's
// energy of a hole in a wave becomes 19 times that of the start, with 10 six times; the shape is
// the same).
constexpr double kHoldHalved = 0.1, kHoldOnFit = 10.0;
// The degree's own number is enough for a few steps; to the end, displacements that change no
// residual are found and taken.
constexpr int kMorePoints = 2;
constexpr int kMostStepsToTheEnd = 30;
// Of the energy at the start, on a surface that has none.
constexpr double kVanishing = 1e-3;
// A level of more control points costs more than it gives. On a fit's knots, which are dense next
// to the corners, an energy of second order would crease there.
constexpr int kMostPointsHalved = 450, kMostPointsOfFit = 500;

std::unique_ptr<shape_energy::ShapeEnergy> shapeEnergy(EnergyKind kind, double diagonal) {
  switch (kind) {
    case EnergyKind::MeanCurvatureGradient:
    case EnergyKind::MeanCurvatureGradientMinimum:
      return std::make_unique<shape_energy::MeanCurvatureGradient>();
    case EnergyKind::MinimumVariation:
      return std::make_unique<shape_energy::MinimumVariation>(shape_energy::kUmbilicShare /
                                                              diagonal);
    case EnergyKind::TotalCurvature:
      return std::make_unique<shape_energy::TotalCurvature>();
    case EnergyKind::Membrane:
    case EnergyKind::ThinPlate:
    case EnergyKind::Triharmonic:
      break;
  }
  return nullptr;
}

int quickSteps(LayoutKind kind) {
  if (kind == LayoutKind::Strip) return kStepsOfStrips;
  return kind == LayoutKind::Junction ? kStepsOfJunctions : kSteps;
}

int highestDegree(const layout::PatchLayout& layout) {
  int highest = 0;
  for (const spline::KnotVector& knots : layout.stripKnots)
    highest = std::max(highest, knots.degree());
  return highest;
}

Effort effortOf(const FillOptions& options, const layout::PatchLayout& layout) {
  const EnergyKind energy = options.energy;
  if (energy == EnergyKind::MeanCurvatureGradient)
    return {1e-3,
            14,
            quickSteps(layout.kind),
            1e-3,
            0.0,
            false,
            0,
            {kPinning, 0.0},
            options.quadrature};
  const bool isOfSecondOrder = energy == EnergyKind::TotalCurvature;
  const double anchor = isOfSecondOrder ? kAnchorOfSecondOrder : kAnchorOfThirdOrder;
  return {1e-5,
          24,
          kMostStepsToTheEnd,
          2e-3,
          2e-6,
          true,
          isOfSecondOrder ? 0 : kMostPointsOfFit,
          {0.0, anchor},
          options.quadrature.orPoints(highestDegree(layout) + kMorePoints)};
}

// The place where the patches come nearest to having no normal.
Eigen::Vector3d mostSingularPlace(const Patches& patches) {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (const spline::BsplineSurface& patch : patches)
    for (const double u : patch.u.grevilleAbscissae())
      for (const double v : patch.v.grevilleAbscissae()) {
        const spline::SurfaceJet jet = patch.jet(u, v);
        const double area = jet.u.cross(jet.v).norm();
        if (area < least) {
          least = area;
          place = jet.point;
        }
      }
  return place;
}

// The same layout with every span halved.
layout::PatchLayout halved(const layout::LayoutPlan& plan, const layout::PatchLayout& layout) {
  const auto middles = [](const spline::KnotVector& knots) {
    const std::vector<double> breaks = knots.breaks();
    std::vector<double> result;
    for (std::size_t k = 1; k < breaks.size(); ++k)
      result.push_back(0.5 * (breaks[k - 1] + breaks[k]));
    return result;
  };
  std::vector<layout::KnotWish> wishes;
  for (const layout::LayoutPatch& patch : layout.patches)
    wishes.push_back({middles(patch.u), middles(patch.v)});
  return layout::refineLayout(plan, layout, wishes);
}

// Where a shape's steps go on.
struct FinerKnots {
  layout::PatchLayout layout;
  bool holdFit;  // the knots of the fit are among them
  double hold;   // times the anchor before
};

// The knots of what is fitted to the shape: its steps then end in the result. A shape without
// energy lacks nothing but knots, so it is given both these and its own, halved.
std::optional<FinerKnots> finerKnots(const layout::LayoutPlan& plan,
                                     const layout::PatchLayout& fitted,
                                     int mostPointsOfFit,
                                     const FairShape& shape) {
  layout::PatchLayout finer = halved(plan, shape.layout);
  if (shape.energy < kVanishing * shape.history.start) {
    layout::PatchLayout both = layout::withKnotsOf(plan, fitted, finer);
    if (both.pointCount <= mostPointsOfFit) return FinerKnots{both, true, kHoldHalved};
  }
  if (fitted.pointCount <= mostPointsOfFit) return FinerKnots{fitted, true, kHoldOnFit};
  if (finer.pointCount <= kMostPointsHalved) return FinerKnots{finer, false, kHoldHalved};
  return std::nullopt;
}

// One plan's shape, made fairer step by step.
class Improvement {
 public:
  Improvement(const layout::LayoutPlan& plan,
              const FillOptions& options,
              const shape_energy::ShapeEnergy& energy,
              double size,
              Progress* progress)
      : plan_(plan), options_(options), energy_(energy), size_(size), progress_(progress) {}

  // The quadratic solution, or what is nearest to a shape and meets all that is asked.
  [[nodiscard]] Result<solver::Points> solveFor(const layout::PatchLayout& layout,
                                                const Aim& aim,
                                                bool iterated) {
    auto program = iterated
                       ? makeProgram(plan_, layout, EnergyKind::ThinPlate, aim, options_.through)
                       : makeProgram(plan_, layout, EnergyKind::ThinPlate, aim);
    if (!program) return fail(program.error());
    auto solution = solver::solve(*program);
    if (!solution) return fail(solution.error());
    program_ = std::move(*program);
    return std::move(solution->points);
  }

  // Steps from the points of the last solveFor() until one is not worth it.
  [[nodiscard]] Result<solver::Points> descend(FairShape& shape,
                                               solver::Points points,
                                               const Effort& effort,
                                               int level) {
    const solver::Points start = points;
    std::optional<ShapeDescent> descent;  // lasts as long as its program
    shape.energy =
        assembly::shapeEnergyOf(makePatches(shape.layout, points), energy_, effort.quadrature);
    shape.history.end = solver::ShapeEnd::Limit;
    for (int k = 0; k < effort.steps; ++k) {
      if (progress_ && progress_->isAbortRequested()) return fail({ErrorCode::Cancelled});
      if (isToStop()) {
        shape.history.end = solver::ShapeEnd::Stopped;
        break;
      }
      if (isIterated(plan_, options_)) {
        auto moved = solveFor(shape.layout, {points, points, {}}, true);
        if (!moved) return moved;
        points = std::move(*moved);
        descent.reset();
      }
      if (!descent)
        descent.emplace(
            shape.layout, energy_, program_, start, size_, effort.hold, effort.quadrature);
      const ShapeStep step = descent->step(points);
      shape.energy = step.energy;
      if (step.fell) shape.history.steps.push_back({level, step.energy, step.anchor, step.length});
      if (!step.fell ||
          step.before - (step.energy + step.anchor) < effort.worthAStep * step.before ||
          step.length < effort.settled * size_) {
        shape.history.end = solver::ShapeEnd::Converged;
        break;
      }
    }
    return points;
  }

  [[nodiscard]] bool isToStop() const { return progress_ && progress_->isFinishRequested(); }

 private:
  const layout::LayoutPlan& plan_;
  const FillOptions& options_;
  const shape_energy::ShapeEnergy& energy_;
  double size_;
  Progress* progress_;
  solver::QuadraticProgram program_;
};

}  // namespace

Result<std::optional<FairShape>> fairShape(const layout::LayoutPlan& plan,
                                           const layout::PatchLayout& layout,
                                           const FillOptions& options,
                                           double diagonal,
                                           Progress* progress) {
  const auto energy = shapeEnergy(options.energy, diagonal);
  if (!energy) return std::nullopt;
  const Effort effort = effortOf(options, layout);
  const bool needsMore = layout.patches.size() > 1 || options.guidance.acts();
  const double density = needsMore ? kHighDensity : kDensity;
  FairShape shape;
  shape.layout = layout::coarseLayout(
      plan, layout, {density, effort.fitShare * diagonal, effort.mostPolesAlong});
  Improvement improvement(plan, options, *energy, diagonal, progress);
  auto points = improvement.solveFor(shape.layout, {}, false);
  if (!points) return fail(points.error());
  shape.patches = makePatches(shape.layout, *points);
  shape.history.start = assembly::shapeEnergyOf(shape.patches, *energy, effort.quadrature);
  if (!std::isfinite(shape.history.start)) {  // what is quadratic is defined everywhere
    shape.history.end = solver::ShapeEnd::Undefined;
    shape.history.where = mostSingularPlace(shape.patches);
    return shape;
  }
  points = improvement.descend(shape, std::move(*points), effort, 0);
  if (!points) return fail(points.error());
  shape.patches = makePatches(shape.layout, *points);
  if (!effort.toTheEnd && shape.history.end != solver::ShapeEnd::Stopped)
    shape.history.end = solver::ShapeEnd::Quick;
  return shape;
}

Result<bool> fairFurther(const layout::LayoutPlan& plan,
                         const layout::PatchLayout& fitted,
                         const Patches& fit,
                         const FillOptions& options,
                         double diagonal,
                         Progress* progress,
                         FairShape& shape) {
  const auto energy = shapeEnergy(options.energy, diagonal);
  Effort effort = effortOf(options, shape.layout);
  const bool hasEnded = shape.history.end == solver::ShapeEnd::Stopped ||
                        shape.history.end == solver::ShapeEnd::Undefined;
  if (!effort.toTheEnd || hasEnded) return false;
  const std::optional<FinerKnots> finer = finerKnots(plan, fitted, effort.mostPointsOfFit, shape);
  if (!finer) return false;
  if (progress && progress->isFinishRequested()) {
    shape.history.end = solver::ShapeEnd::Stopped;
    return false;
  }
  effort.hold.anchor *= finer->hold;
  Aim aim;
  aim.shape = pointsOn(finer->layout, finer->holdFit ? fit : shape.patches);
  Improvement improvement(plan, options, *energy, diagonal, progress);
  auto points = improvement.solveFor(finer->layout, aim, false);
  if (!points) return fail(points.error());
  shape.layout = finer->layout;
  points = improvement.descend(shape, std::move(*points), effort, 1);
  if (!points) return fail(points.error());
  shape.patches = makePatches(shape.layout, *points);
  return true;
}

}  // namespace fairing
