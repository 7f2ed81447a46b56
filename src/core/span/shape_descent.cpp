// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/shape_descent.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/assembly/assemble_energy.h"
#include "core/assembly/assemble_shape_energy.h"
#include "core/base/stopwatch.h"
#include "core/solver/solve.h"
#include "core/solver/tie_points.h"
#include "core/span/span_hole.h"

// One step d from the points x, in the directions T that the constraints leave free:
//   (T' (c H + w P / s^2 + A + m M / s^2) T) y = -T' (c g + A (x - x0)),   d = T y
// H, g   Gauss-Newton model of the energy (assembly/assemble_shape_energy.h), or its expansion with
//        all second derivatives; s the hole's diagonal
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
// An undamped step that takes less than this share of the sum away has come to where Gauss-Newton
// is linear, if residuals do not vanish: Newton's are tried. Where they fail, the share has to
// shrink before they are tried again.
constexpr double kNewtonBelow = 0.1, kPatience = 0.1;
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

VectorXd coordinatesOf(const assembly::ShapeElement& element, const solver::Points& points) {
  VectorXd own(3 * static_cast<Index>(element.points.size()));
  for (std::size_t k = 0; k < element.points.size(); ++k)
    own.segment<3>(static_cast<Index>(3 * k)) = points.row(element.points[k]);
  return own;
}

solver::Sparse displacementOf(const layout::PatchLayout& layout, const solver::Sparse& freedom) {
  const solver::Sparse mass =
      solver::threefold(assembly::assembleEnergy(layout, {{1.0, {0, 0}, {0, 0}}}));
  return freedom.transpose() * solver::Sparse(mass * freedom);
}

}  // namespace

struct ShapeDescent::Model {
  solver::Sparse hessian;  // in the free directions
  VectorXd gradient;
};

struct ShapeDescent::Place {
  solver::Points points;
  Patches patches;
  double energy, anchor;
  [[nodiscard]] double sum() const { return energy + anchor; }
};

struct ShapeDescent::Trial {
  solver::Points points;
  ShapeStep step;
  double asExpected = 0.0;  // share of the fall that the model expects
};

ShapeDescent::ShapeDescent(const layout::PatchLayout& layout,
                           const shape_energy::ShapeEnergy& energy,
                           const solver::QuadraticProgram& program,
                           const solver::Points& start,
                           double size,
                           const ShapeHold& hold,
                           const spline::QuadratureRule& quadrature)
    : layout_(layout),
      energy_(energy),
      freedom_(solver::freedomOf(program)),
      free_(freedom_, assembly::spanPoints(layout)),
      displacement_(displacementOf(layout, freedom_)),
      factor_(solver::Sparse(free_.pattern() + displacement_), freedom_),
      size_(size),
      scale_(std::pow(size, -energy.sizePower())),
      quadrature_(quadrature),
      pinning_(hold.step / (size * size * scale_)),
      start_(start),
      anchorWeight_(hold.anchor / (size * size)),
      newtonBelow_(kNewtonBelow) {
  if (hold.anchor > 0.0) anchor_ = assembly::assembleTangential(layout, makePatches(layout, start));
}

double ShapeDescent::energyAt(const solver::Points& points) const {
  return assembly::shapeEnergyOf(makePatches(layout_, points), energy_, quadrature_);
}

double ShapeDescent::anchorAt(const solver::Points& points) const {
  const solver::Points off = points - start_;
  double sum = 0.0;
  for (const assembly::ShapeElement& e : anchor_) {
    const VectorXd own = coordinatesOf(e, off);
    sum += own.dot(e.hessian * own);
  }
  return 0.5 * anchorWeight_ * sum / scale_;
}

ShapeDescent::Place ShapeDescent::placeAt(const solver::Points& points) {
  Stopwatch watch;
  Place place{points, makePatches(layout_, points), 0.0, anchorAt(points)};
  place.energy = assembly::shapeEnergyOf(place.patches, energy_, quadrature_);
  times_.evaluation += watch.lap();
  return place;
}

// The factor is of the displacement's pattern, too, whatever its weight.
solver::Sparse ShapeDescent::damped(const Model& model, double damping) const {
  return model.hessian + damping / (size_ * size_) * displacement_;
}

ShapeDescent::Model ShapeDescent::modelOf(std::vector<assembly::ShapeElement> elements,
                                          const solver::Points& points) const {
  const solver::Points off = points - start_;
  VectorXd gradient = VectorXd::Zero(3 * layout_.pointCount);
  std::vector<MatrixXd> hessians;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    assembly::ShapeElement& e = elements[k];
    e.gradient *= scale_;
    e.hessian *= scale_;
    if (!anchor_.empty()) {
      e.gradient += anchorWeight_ * (anchor_[k].hessian * coordinatesOf(e, off));
      e.hessian += anchorWeight_ * anchor_[k].hessian;
    }
    for (std::size_t b = 0; b < e.points.size(); ++b)
      gradient.segment<3>(3 * e.points[b]) += e.gradient.segment<3>(static_cast<Index>(3 * b));
    hessians.push_back(std::move(e.hessian));
  }
  return {free_.sum(hessians), freedom_.transpose() * gradient};
}

// The step that a matrix makes of a gradient, if it lets the sum fall and folds nothing.
std::optional<ShapeDescent::Trial> ShapeDescent::tried(const solver::Sparse& matrix,
                                                       const Model& model,
                                                       const Place& from) {
  Stopwatch watch;
  const bool isDefinite = factor_.factorize(matrix);
  const VectorXd free = isDefinite ? factor_.solve(-model.gradient) : VectorXd();
  times_.factorisation += watch.lap();
  if (!isDefinite) return std::nullopt;
  const VectorXd moved = freedom_ * free;
  const Place to =
      placeAt(from.points + Eigen::Map<const solver::Points>(moved.data(), moved.size() / 3, 3));
  const double fall = from.sum() - to.sum();
  if (!(fall > 0.0) || folds(from.patches, to.patches)) return std::nullopt;
  Trial trial{to.points, {true, from.sum(), to.energy, to.anchor}};
  trial.step.length = std::sqrt(3.0 * moved.squaredNorm() / static_cast<double>(moved.size()));
  trial.asExpected =
      -fall * scale_ / (model.gradient.dot(free) + 0.5 * free.dot(model.hessian * free));
  return trial;
}

ShapeStep ShapeDescent::step(solver::Points& points) {
  const Place from = placeAt(points);
  if (isSlow_) {
    if (auto trial = newtonFrom(from)) {
      points = std::move(trial->points);
      return trial->step;
    }
    newtonBelow_ *= kPatience;
  }
  Stopwatch watch;
  const Model model = modelOf(
      assembly::assembleShapeEnergy(layout_, from.patches, energy_, quadrature_, pinning_), points);
  times_.assembly += watch.lap();
  isSlow_ = false;
  for (int k = 0; k < kTrials; ++k) {
    const auto trial = tried(damped(model, damping_), model, from);
    if (trial) {
      const double fall = from.sum() - (trial->step.energy + trial->step.anchor);
      isSlow_ = !anchor_.empty() && damping_ == 0.0 && fall < newtonBelow_ * from.sum();
      if (anchor_.empty() || trial->asExpected > kGoodModel)
        damping_ = damping_ > kFirstDamping ? kRelief * damping_ : 0.0;
      points = trial->points;
      return trial->step;
    }
    damping_ = damping_ == 0.0 ? kFirstDamping : kDampingFactor * damping_;
  }
  return {false, from.sum(), from.energy, from.anchor};
}

std::optional<ShapeDescent::Trial> ShapeDescent::newtonFrom(const Place& from) {
  Stopwatch watch;
  const Model model = modelOf(
      assembly::expandShapeEnergy(layout_, from.patches, energy_, quadrature_), from.points);
  times_.assembly += watch.lap();
  return tried(damped(model, 0.0), model, from);
}

std::optional<ShapeStep> ShapeDescent::newtonStep(solver::Points& points) {
  auto trial = newtonFrom(placeAt(points));
  if (!trial) return std::nullopt;
  points = std::move(trial->points);
  return trial->step;
}

}  // namespace fairing
