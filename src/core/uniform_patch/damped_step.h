// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/uniform_patch/blending_functional.h"

namespace fairing::uniform_patch {

/// A step of the free points to a lower F.
struct DampedStep {
  double damping = 0.0;
  spline::Poles points;   ///< all control points after it
  double value = 0.0;     ///< F there
  double promised = 0.0;  ///< at least what the model of F says it falls by: -1/2 gradient . step
  double length = 0.0;    ///< largest move of a control point, mm
  std::optional<solver::BandCholesky> factor = std::nullopt;
};

/// Steps of a trust region method,
///   (H + damping * M) d = -gradient,   M = c0 times the second derivative of T,
/// which minimise the model of F among all steps that are not longer in the metric M: a step is as
/// long as its undulations allow. Where H is indefinite, as it is far from a minimum, the damping
/// is found that makes the matrix definite and F lowest along the family of these steps, coarsely.
class DampedSearch {
 public:
  DampedSearch(const ConstrainedNet& start, const BlendingFunctional& functional, double c0);

  /// The best step found, or nothing if none lowers F.
  [[nodiscard]] std::optional<DampedStep> best(const spline::Poles& points,
                                               const BlendingModel& model);
  /// The step of a given factor for a given gradient.
  [[nodiscard]] DampedStep along(const spline::Poles& points,
                                 const Eigen::VectorXd& gradient,
                                 const solver::BandCholesky& factor) const;
  /// How many matrices the last search has factored.
  [[nodiscard]] int factorisations() const { return factorisations_; }

 private:
  struct Place;  // where a search is
  [[nodiscard]] std::optional<DampedStep> lowering(const Place& place, double damping);
  void raise(const Place& place, double damping, std::optional<DampedStep>& best);
  void raiseOnce(const Place& place, std::optional<DampedStep>& best);
  void lower(const Place& place, std::optional<DampedStep>& best);
  void waitWithNewton();
  [[nodiscard]] double lowered(double damping) const;

  const FreePoints* free_;
  const BlendingFunctional* functional_;
  solver::BandMatrix metric_;  // of one coordinate
  double suggested_ = 0.0;     // damping to begin with
  double newtonBelow_ = 1.0;   // below this no damping is tried
  int factorisations_ = 0;
};

}  // namespace fairing::uniform_patch
