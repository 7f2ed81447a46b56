// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/tolerance.h"
#include "core/boundary/continuity.h"
#include "core/constraint/inner_constraint.h"
#include "core/energy/energy_kind.h"
#include "core/energy/guidance.h"
#include "core/layout/layout_kind.h"
#include "core/spline/quadrature.h"

namespace fairing {

/// Everything a caller may choose about a fill.
struct FillOptions {
  LayoutKind layout = LayoutKind::Auto;
  EnergyKind energy = EnergyKind::MeanCurvatureGradient;
  std::vector<InnerConstraint> through;  ///< what the patches must pass through
  energy::Guidance guidance;             ///< lambda, gamma and what they refer to; none by default
  Continuity inner = Continuity::G1;     ///< how patches meet each other, G1 or G2
  /// Of energies of the shape; points a span and direction, 2 to 32, 0 = chosen from the degree.
  spline::QuadratureRule quadrature;
  Tolerance tolerance;
  int degree = 0;          ///< 0 = chosen from the edges; else 3 to 9, never below the edges' own
  int maxRefinements = 6;  ///< solves after the first one
  int maxPoles = 2500;     ///< largest number of control points of all patches
};

/// The first thing wrong with the options, if any: ToleranceNotPositive, AngleNotPositive,
/// WeightNegative, DegreeTooLow, DegreeOutOfRange, QuadratureOutOfRange, FieldUnplaced,
/// UnknownChoice...
[[nodiscard]] std::optional<Error> validate(const FillOptions& options);

}  // namespace fairing
