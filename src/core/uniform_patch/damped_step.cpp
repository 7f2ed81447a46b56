// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/damped_step.h"

#include <cmath>

#include "core/uniform_patch/triharmonic.h"

namespace fairing::uniform_patch {
namespace {

// Dampings are tried in these ratios: a step's value changes little within one.
constexpr double kRatio = 8.0;

// Above this, steps are too short to matter.
constexpr double kMostDamping = 1e12;

// After a Newton step has failed, damping must fall by this before the next is tried.
constexpr double kPatience = 64.0;
constexpr double kLeastThreshold = 1e-12;

// A step that lowers F by less than this share of what the model says wants more damping.
constexpr double kPoor = 0.8;

}  // namespace

struct DampedSearch::Place {
  const spline::Poles& points;
  const BlendingModel& model;
};

DampedSearch::DampedSearch(const ConstrainedNet& start,
                           const BlendingFunctional& functional,
                           double c0)
    : free_(&start.free),
      functional_(&functional),
      metric_(triharmonicStiffness(start.net, start.free)) {
  metric_.scale(2.0 * c0);
}

DampedStep DampedSearch::along(const spline::Poles& points,
                               const Eigen::VectorXd& gradient,
                               const solver::BandCholesky& factor) const {
  const Eigen::VectorXd step = factor.solve(-gradient);
  const spline::Poles moves =
      free_->spread(Eigen::Map<const spline::Poles>(step.data(), step.size() / 3, 3));
  DampedStep result;
  result.points = points + moves;
  result.value = functional_->total(result.points);
  result.promised = -0.5 * gradient.dot(step);
  result.length = moves.rowwise().norm().maxCoeff();
  return result;
}

// The step with a damping, if the matrix is definite and F falls.
std::optional<DampedStep> DampedSearch::lowering(const Place& place, double damping) {
  solver::BandMatrix matrix = place.model.hessian;
  if (damping > 0.0) matrix.addThreefold(damping, metric_);
  ++factorisations_;
  auto factor = solver::BandCholesky::factor(std::move(matrix), functional_->threads());
  if (!factor) return std::nullopt;
  DampedStep step = along(place.points, place.model.gradient, *factor);
  // at the minimum rounding hides what a step changes
  const double rounding = damping == 0.0 ? 1e-14 * place.model.value : 0.0;
  if (!(step.value < place.model.value + rounding)) return std::nullopt;
  step.damping = damping;
  if (damping == 0.0) step.factor = std::move(factor);
  return step;
}

double DampedSearch::lowered(double damping) const {
  return damping <= newtonBelow_ ? 0.0 : damping / kRatio;
}

// A step with more damping, if F is lower there.
void DampedSearch::raiseOnce(const Place& place, std::optional<DampedStep>& best) {
  if (auto more = lowering(place, kRatio * best->damping); more && more->value < best->value)
    best = std::move(more);
}

// Raises the damping until F falls, and once more: the first step that lowers F is often a wild
// one.
void DampedSearch::raise(const Place& place, double damping, std::optional<DampedStep>& best) {
  for (; !best && damping < kMostDamping; damping *= kRatio) best = lowering(place, damping);
  if (best) raiseOnce(place, best);
}

// Lowers the damping as long as F falls the lower for it.
void DampedSearch::lower(const Place& place, std::optional<DampedStep>& best) {
  while (best->damping > 0.0) {
    const double damping = lowered(best->damping);
    auto less = lowering(place, damping);
    if (!less && damping == 0.0) waitWithNewton();
    if (!less || less->value >= best->value) return;
    best = std::move(less);
  }
}

void DampedSearch::waitWithNewton() {
  newtonBelow_ = std::max(newtonBelow_ / kPatience, kLeastThreshold);
}

std::optional<DampedStep> DampedSearch::best(const spline::Poles& points,
                                             const BlendingModel& model) {
  const Place place{points, model};
  factorisations_ = 0;
  std::optional<DampedStep> best = lowering(place, suggested_);
  if (best) {
    const double first = best->damping;
    lower(place, best);
    const bool isPoor = model.value - best->value <= kPoor * best->promised;
    if (first > 0.0 && best->damping == first && isPoor) raiseOnce(place, best);
  } else if (suggested_ > 0.0) {
    raise(place, kRatio * suggested_, best);
  } else {
    const double first = newtonBelow_;
    waitWithNewton();
    raise(place, first, best);
    if (best && best->damping == first) lower(place, best);
  }
  if (best) suggested_ = best->damping > 0.0 ? lowered(best->damping) : 0.0;
  return best;
}

}  // namespace fairing::uniform_patch
