// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/fair_shape.h"

#include <Eigen/Cholesky>
#include <memory>

#include "core/assembly/assemble_energy.h"
#include "core/assembly/assemble_shape_energy.h"
#include "core/layout/layouts.h"
#include "core/shape_energy/mean_curvature_gradient.h"
#include "core/solver/tie_points.h"

// One step d from the points x, in the directions T that the constraints leave free:
//   (T' (s^2 H + w P / s^2 + m M / s^2) T) y = -T' s^2 g,   d = T y
// H, g   Gauss-Newton model of the energy (assembly/assemble_shape_energy.h), s the hole's diagonal
// P      tangential part of the displacement, over the surface: the energy does not see the
//        parametrisation, which would drift
// M      the whole displacement, over the parameters
// m      Levenberg-Marquardt weight, raised until the true energy falls [NocedalWright2006] 10.3,
//        and lowered after a step: the next one starts with what is left of it

namespace fairing {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Spans over a length as long as the hole is wide. Patches that meet in an inner vertex need more
// (an octant of a sphere: 4e-5 of the diagonal off at 2, 5e-6 at 3), and so does what guidance
// shapes.
constexpr double kDensity = 2.0, kHighDensity = 3.0;
constexpr double kFitShare = 1e-3;  // of the diagonal: how closely the sides are followed
constexpr int kMostPolesAlong = 14;
constexpr int kSteps = 2;
// A strip's start is farther from its end: nothing holds its middle.
constexpr int kStepsOfStrips = 8, kStepsOfJunctions = 16;
constexpr double kWorthAStep = 1e-3;  // of the energy
// As an integral; 1e4 lets the parametrisation drift: one round more on stars, and waves farther
// off.
constexpr double kPinning = 1e5;
constexpr int kTrials = 12;
constexpr double kFirstDamping = 1e2, kDampingFactor = 3.0, kRelief = 0.1;

std::unique_ptr<shape_energy::ShapeEnergy> shapeEnergy(EnergyKind kind) {
  switch (kind) {
    case EnergyKind::MeanCurvatureGradient:
      return std::make_unique<shape_energy::MeanCurvatureGradient>();
    case EnergyKind::Membrane:
    case EnergyKind::ThinPlate:
      break;
  }
  return nullptr;
}

int mostSteps(LayoutKind kind) {
  if (kind == LayoutKind::Strip) return kStepsOfStrips;
  return kind == LayoutKind::Junction ? kStepsOfJunctions : kSteps;
}

struct Model {
  MatrixXd hessian;  // 3n x 3n
  VectorXd gradient;
};

Model modelOf(const layout::PatchLayout& layout,
              const Patches& patches,
              const shape_energy::ShapeEnergy& energy,
              double size) {
  const Index n = 3 * layout.pointCount;
  Model model{MatrixXd::Zero(n, n), VectorXd::Zero(n)};
  const double pinning = kPinning / (size * size * size * size);
  for (const assembly::ShapeElement& e :
       assembly::assembleShapeEnergy(layout, patches, energy, 0, pinning)) {
    for (std::size_t b = 0; b < e.points.size(); ++b) {
      const auto column = static_cast<Index>(3 * b), to = static_cast<Index>(3 * e.points[b]);
      model.gradient.segment<3>(to) += size * size * e.gradient.segment<3>(column);
      for (std::size_t a = 0; a < e.points.size(); ++a)
        model.hessian.block<3, 3>(3 * e.points[a], to) +=
            size * size * e.hessian.block<3, 3>(static_cast<Index>(3 * a), column);
    }
  }
  return model;
}

// The model in the free directions.
Model projected(const Model& model, const solver::Sparse& freedom) {
  const MatrixXd reached = model.hessian * freedom;
  return {freedom.transpose() * reached, freedom.transpose() * model.gradient};
}

class Descent {
 public:
  Descent(const layout::PatchLayout& layout,
          const shape_energy::ShapeEnergy& energy,
          const solver::QuadraticProgram& program,
          double size)
      : layout_(layout), energy_(energy), freedom_(solver::freedomOf(program)), size_(size) {}

  [[nodiscard]] double energyAt(const solver::Points& points) const {
    return assembly::shapeEnergyOf(makePatches(layout_, points), energy_);
  }
  // Takes a step; false where none lets the energy fall.
  bool step(solver::Points& points, double& value) {
    const Model model =
        projected(modelOf(layout_, makePatches(layout_, points), energy_, size_), freedom_);
    for (int trial = 0; trial < kTrials; ++trial) {
      MatrixXd matrix = model.hessian;
      if (damping_ > 0.0) matrix += damping_ / (size_ * size_) * displacement();
      const Eigen::LLT<MatrixXd> factors(matrix);
      if (factors.info() == Eigen::Success) {
        const VectorXd moved = freedom_ * factors.solve(-model.gradient);
        const solver::Points next =
            points + Eigen::Map<const solver::Points>(moved.data(), points.rows(), 3);
        const double reached = energyAt(next);
        if (reached < value) {
          points = next;
          value = reached;
          damping_ = damping_ > kFirstDamping ? kRelief * damping_ : 0.0;
          return true;
        }
      }
      damping_ = damping_ == 0.0 ? kFirstDamping : kDampingFactor * damping_;
    }
    return false;
  }

 private:
  // The integral of |d|^2 in the free directions, made where a step is rejected.
  const solver::Sparse& displacement() {
    if (displacement_) return *displacement_;
    const solver::Sparse mass =
        solver::threefold(assembly::assembleEnergy(layout_, {{1.0, {0, 0}, {0, 0}}}));
    displacement_ = freedom_.transpose() * solver::Sparse(mass * freedom_);
    return *displacement_;
  }

  const layout::PatchLayout& layout_;
  const shape_energy::ShapeEnergy& energy_;
  solver::Sparse freedom_;
  std::optional<solver::Sparse> displacement_;
  double size_;
  double damping_ = 0.0;
};

}  // namespace

Result<std::optional<FairShape>> fairShape(const layout::LayoutPlan& plan,
                                           const layout::PatchLayout& layout,
                                           const FillOptions& options,
                                           double diagonal,
                                           Progress* progress) {
  const auto energy = shapeEnergy(options.energy);
  if (!energy) return std::nullopt;
  const bool needsMore = layout.patches.size() > 1 || options.guidance.acts();
  const double density = needsMore ? kHighDensity : kDensity;
  FairShape shape{
      layout::coarseLayout(plan, layout, {density, kFitShare * diagonal, kMostPolesAlong}), {}};
  auto program = makeProgram(plan, shape.layout, EnergyKind::ThinPlate);
  if (!program) return fail(program.error());
  auto current = solver::solve(*program);
  if (!current) return fail(current.error());
  shape.energyBefore = shape.energy =
      assembly::shapeEnergyOf(makePatches(shape.layout, current->points), *energy);
  std::optional<Descent> descent;  // lasts as long as its program
  while (shape.steps < mostSteps(layout.kind)) {
    if (progress && progress->isAbortRequested()) return fail({ErrorCode::Cancelled});
    if (isIterated(plan.cut.loop, options)) {  // the nearest points that meet all that is asked
      program = makeProgram(plan,
                            shape.layout,
                            EnergyKind::ThinPlate,
                            {current->points, current->points, {}},
                            options.through);
      if (!program) return fail(program.error());
      current = solver::solve(*program);
      if (!current) return fail(current.error());
      shape.energy = assembly::shapeEnergyOf(makePatches(shape.layout, current->points), *energy);
      descent.reset();
    }
    if (!descent) descent.emplace(shape.layout, *energy, *program, diagonal);
    const double before = shape.energy;
    if (!descent->step(current->points, shape.energy)) break;
    ++shape.steps;
    if (before - shape.energy < kWorthAStep * before) break;
  }
  shape.patches = makePatches(shape.layout, current->points);
  return shape;
}

}  // namespace fairing
