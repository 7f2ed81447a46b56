// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/uniform_patch/control_net.h"

namespace fairing::uniform_patch {

/// A constant parameter curve of the patch that is to stay [Kiciak2011] section 5.
struct FixedCurve {
  enum class Constant { U, V };
  Constant constant = Constant::U;
  double parameter = 0.0;  ///< of the domain
  /// Its control points on the knots of the other direction, all of them; none = it stays where the
  /// given net has it.
  std::optional<spline::Poles> points = std::nullopt;
};

/// Control points of a net's curve at the parameter, as a FixedCurve has them. The parameter lies
/// in the domain.
[[nodiscard]] spline::Poles curvePoints(const ControlNet& net, const FixedCurve& curve);

/// What the rings and the fixed curves leave free of a control net, exactly: a net that obeys them
/// still does when its control points move by  sum of factor * d_f  over their terms, d_f the moves
/// of the free points.
struct FreePoints {
  struct Term {
    int free;
    double factor;
  };
  std::vector<std::vector<Term>> terms;  ///< of every control point; none = it is fixed
  int count = 0;                         ///< free points

  /// The control points' moves from those of the free points, one row a point.
  [[nodiscard]] spline::Poles spread(const spline::Poles& moves) const;
  /// The slopes of a function of the control points with respect to the free points' moves.
  [[nodiscard]] spline::Poles gather(const spline::Poles& slopes) const;
  /// The largest distance, in their numbering, of two free points that move the same span.
  [[nodiscard]] int couplingWidth(const ControlNet& net) const;
};

/// A net that obeys the rings and the curves, and what is left free of it.
struct ConstrainedNet {
  ControlNet net;
  FreePoints free;
};

/// Moves the inner points onto the curves. Fails as validate() does, with CurveOutside at a
/// parameter outside the domain, and with CurvesContradict where a curve leaves the given rings or
/// two curves miss each other by more than 1e-9 of the border's diameter.
[[nodiscard]] Result<ConstrainedNet> constrain(const ControlNet& net,
                                               const std::vector<FixedCurve>& curves = {});

}  // namespace fairing::uniform_patch
