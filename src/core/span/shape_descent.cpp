// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/shape_descent.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

#include "core/assembly/assemble_energy.h"
#include "core/assembly/assemble_shape_energy.h"
#include "core/solver/solve.h"
#include "core/solver/tie_points.h"
#include "core/span/span_hole.h"

// One step d from the points x, in the directions T that the constraints leave free:
//   (T' (c H + w P / s^2 + A + m M / s^2) T) y = -T' (c g + A (x - x0)),   d = T y
// H, g   Gauss-Newton model of the energy (assembly/assemble_shape_energy.h), s the hole's diagonal
// c      the power of s that makes the energy a number without unit
// P      tangential part of the displacement, over the surface: the energy does not see the
//        parametrisation, which would drift
// A      the same part on the surface of the start x0, times a / s^2: it holds where it was what P
//        only slows down, and adds 1/2 (x - x0)' A (x - x0) to what has to fall [Kiciak2011] 4
// M      the whole displacement, over the parameters
// m      Levenberg-Marquardt weight, raised until the true energy falls [NocedalWright2006] 10.3,
//        and lowered after a step: the next one starts with what is left of it

namespace fairing {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kTrials = 12;
constexpr double kFirstDamping = 1e2, kDampingFactor = 3.0, kRelief = 0.1;
// Share of the expected fall from which on the model may be trusted farther. On the few steps
// without an anchor it always is.
constexpr double kGoodModel = 0.7;
// Of its area before a step, with its sign: what a piece of a patch has to keep.
constexpr double kLeastArea = 0.05;

Vector3d normalAt(const spline::BsplineSurface& patch, double u, double v) {
  const auto jet = patch.jet(u, v);
  return jet.u.cross(jet.v);
}

// Whether a patch turns over somewhere, or nearly so.
bool folds(const Patches& before, const Patches& after) {
  for (std::size_t p = 0; p < before.size(); ++p)
    for (const double u : before[p].u.grevilleAbscissae())
      for (const double v : before[p].v.grevilleAbscissae()) {
        const Vector3d normal = normalAt(before[p], u, v);
        if (normalAt(after[p], u, v).dot(normal) < kLeastArea * normal.squaredNorm()) return true;
      }
  return false;
}

}  // namespace

struct ShapeDescent::Model {
  MatrixXd hessian;  // in the free directions
  VectorXd gradient;
};

ShapeDescent::ShapeDescent(const layout::PatchLayout& layout,
                           const shape_energy::ShapeEnergy& energy,
                           const solver::QuadraticProgram& program,
                           const solver::Points& start,
                           double size,
                           const ShapeHold& hold,
                           int quadrature)
    : layout_(layout),
      energy_(energy),
      freedom_(solver::freedomOf(program)),
      size_(size),
      scale_(std::pow(size, -energy.sizePower())),
      quadrature_(quadrature),
      pinning_(hold.step / (size * size * scale_)),
      start_(start) {
  if (hold.anchor > 0.0)
    anchor_ = hold.anchor / (size * size) *
              assembly::assembleTangential(layout, makePatches(layout, start));
}

double ShapeDescent::energyAt(const solver::Points& points) const {
  return assembly::shapeEnergyOf(makePatches(layout_, points), energy_, quadrature_);
}

double ShapeDescent::anchorAt(const solver::Points& points) const {
  if (anchor_.size() == 0) return 0.0;
  const VectorXd off = solver::flat(points) - solver::flat(start_);
  return 0.5 * off.dot(anchor_ * off) / scale_;
}

ShapeDescent::Model ShapeDescent::modelAt(const solver::Points& points) const {
  const Index n = 3 * layout_.pointCount;
  MatrixXd hessian = MatrixXd::Zero(n, n);
  VectorXd gradient = VectorXd::Zero(n);
  for (const assembly::ShapeElement& e : assembly::assembleShapeEnergy(
           layout_, makePatches(layout_, points), energy_, quadrature_, pinning_)) {
    for (std::size_t b = 0; b < e.points.size(); ++b) {
      const auto column = static_cast<Index>(3 * b), to = static_cast<Index>(3 * e.points[b]);
      gradient.segment<3>(to) += scale_ * e.gradient.segment<3>(column);
      for (std::size_t a = 0; a < e.points.size(); ++a)
        hessian.block<3, 3>(3 * e.points[a], to) +=
            scale_ * e.hessian.block<3, 3>(static_cast<Index>(3 * a), column);
    }
  }
  if (anchor_.size() > 0) {
    hessian += anchor_;
    gradient += anchor_ * (solver::flat(points) - solver::flat(start_));
  }
  const MatrixXd reached = hessian * freedom_;
  return {freedom_.transpose() * reached, freedom_.transpose() * gradient};
}

ShapeStep ShapeDescent::step(solver::Points& points) {
  const Model model = modelAt(points);
  const Patches patches = makePatches(layout_, points);
  ShapeStep stay{.energy = energyAt(points), .anchor = anchorAt(points)};
  stay.before = stay.energy + stay.anchor;
  for (int trial = 0; trial < kTrials; ++trial) {
    MatrixXd matrix = model.hessian;
    if (damping_ > 0.0) matrix += damping_ / (size_ * size_) * displacement();
    const Eigen::LLT<MatrixXd> factors(matrix);
    if (factors.info() == Eigen::Success) {
      const VectorXd free = factors.solve(-model.gradient);
      const VectorXd moved = freedom_ * free;
      const solver::Points next =
          points + Eigen::Map<const solver::Points>(moved.data(), points.rows(), 3);
      ShapeStep taken{
          .fell = true, .before = stay.before, .energy = energyAt(next), .anchor = anchorAt(next)};
      const double fall = stay.before - (taken.energy + taken.anchor);
      if (fall > 0.0 && !folds(patches, makePatches(layout_, next))) {
        points = next;
        taken.length = std::sqrt(moved.squaredNorm() / static_cast<double>(points.rows()));
        const double expected =
            -(model.gradient.dot(free) + 0.5 * free.dot(model.hessian * free)) / scale_;
        if (anchor_.size() == 0 || fall > kGoodModel * expected)
          damping_ = damping_ > kFirstDamping ? kRelief * damping_ : 0.0;
        return taken;
      }
    }
    damping_ = damping_ == 0.0 ? kFirstDamping : kDampingFactor * damping_;
  }
  return stay;
}

// The integral of |d|^2 in the free directions, made where a step is rejected.
const solver::Sparse& ShapeDescent::displacement() {
  if (displacement_) return *displacement_;
  const solver::Sparse mass =
      solver::threefold(assembly::assembleEnergy(layout_, {{1.0, {0, 0}, {0, 0}}}));
  displacement_ = freedom_.transpose() * solver::Sparse(mass * freedom_);
  return *displacement_;
}

}  // namespace fairing
