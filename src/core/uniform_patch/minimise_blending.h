// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/base/progress.h"
#include "core/uniform_patch/free_points.h"

namespace fairing::uniform_patch {

struct BlendingOptions {
  /// C >= 0, how much the parametrisation counts beside the shape, free of units: the functional is
  /// F = S + c Q with c = C * (domain diameter / border diameter)^4 [Kiciak2011] section 4.3. With
  /// 0 the parametrisation is not determined, and convergence is slow or fails.
  double weight = 1e-3;
  int stepLimit = 100;
  int threads = 1;  ///< at least 1; the result is the same with any number
};

enum class BlendingOutcome {
  Converged,  ///< a further Newton step would lower F by less than 1e-11 of it
  StepLimit,  ///< the best net so far is returned
  Cancelled,  ///< the best net so far is returned
  Stalled,  ///< no step lowers F though its slope does not vanish: rounding, or a singular net near
};

/// One step: one second derivative of F.
struct BlendingStep {
  double value = 0.0;      ///< F before it
  double slope = 0.0;      ///< norm of F's gradient before it
  double damping = 0.0;    ///< how many times c T is added to the model; 0 = a Newton step
  double length = 0.0;     ///< largest move of a control point, mm
  int factorisations = 0;  ///< linear systems tried
  int corrections = 0;     ///< simplified Newton steps after it, with the same factor
};

struct BlendingReport {
  BlendingOutcome outcome = BlendingOutcome::Converged;
  double c = 0.0;                ///< the factor of Q in F, mm^-4
  double triharmonic = 0.0;      ///< T of the result, mm^2
  double shape = 0.0;            ///< S, mm^-2
  double parametrisation = 0.0;  ///< Q, mm^2
  std::vector<BlendingStep> steps;
  double seconds = 0.0;
  [[nodiscard]] double value() const { return shape + c * parametrisation; }
};

struct BlendingResult {
  ControlNet net;
  BlendingReport report;
};

/// c of F = S + c Q for a net: weight * (domain diameter / border diameter)^4.
[[nodiscard]] double parametrisationFactor(const ControlNet& net, double weight);

/// T, S, Q and F of a net, with quadrature fine enough that their digits are right.
[[nodiscard]] BlendingReport measureBlending(const ControlNet& net, double c, int threads = 1);

/// Minimises F over the free points by Newton's method with a trust region, from the given net. F
/// never rises. Fails with WeightNegative, or NormalVanishes if the start has no normal somewhere.
[[nodiscard]] Result<BlendingResult> minimiseBlending(const ConstrainedNet& start,
                                                      const BlendingOptions& options = {},
                                                      Progress* progress = nullptr);

}  // namespace fairing::uniform_patch
