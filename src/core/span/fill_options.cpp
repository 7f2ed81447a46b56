// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/fill_options.h"

#include <cmath>

namespace fairing {
namespace {

constexpr int kLeastDegree = 3, kLargestDegree = 9;
constexpr int kLeastPoles = 16;
constexpr int kLeastPoints = 2, kMostPoints = 32;

bool isPositive(double value) {
  return std::isfinite(value) && value > 0.0;
}

bool hasThirdDerivatives(EnergyKind energy) {
  switch (energy) {
    case EnergyKind::Membrane:
    case EnergyKind::ThinPlate:
    case EnergyKind::TotalCurvature:
      return false;
    case EnergyKind::MeanCurvatureGradient:
    case EnergyKind::MeanCurvatureGradientMinimum:
    case EnergyKind::MinimumVariation:
    case EnergyKind::Triharmonic:
      break;
  }
  return true;
}

Error error(ErrorCode code, double value) {
  return {.code = code, .value = value};
}

}  // namespace

std::optional<Error> validate(const FillOptions& options) {
  const Tolerance& t = options.tolerance;
  if (t.gap != 0.0 && !isPositive(t.gap)) return error(ErrorCode::ToleranceNotPositive, t.gap);
  if (!isPositive(t.relativeGap)) return error(ErrorCode::ToleranceNotPositive, t.relativeGap);
  if (!isPositive(t.angle)) return error(ErrorCode::AngleNotPositive, t.angle);
  if (!isPositive(t.cornerAngle)) return error(ErrorCode::AngleNotPositive, t.cornerAngle);
  if (auto wrong = energy::validate(options.guidance)) return wrong;
  if (options.guidance.hasField() && !options.guidance.corners)
    return Error{.code = ErrorCode::FieldUnplaced};
  if (options.inner == Continuity::G0)
    return Error{.code = ErrorCode::UnknownChoice, .detail = "\"G0\" for inner continuity"};
  if (options.degree > 0 && options.degree < kLeastDegree && hasThirdDerivatives(options.energy))
    return error(ErrorCode::DegreeTooLow, options.degree);
  if (options.degree != 0 && (options.degree < kLeastDegree || options.degree > kLargestDegree))
    return error(ErrorCode::DegreeOutOfRange, options.degree);
  const int points = options.quadrature.points;
  if (points != 0 && (points < kLeastPoints || points > kMostPoints))
    return error(ErrorCode::QuadratureOutOfRange, points);
  if (options.maxPoles < kLeastPoles) return error(ErrorCode::ControlPointLimit, options.maxPoles);
  return std::nullopt;
}

}  // namespace fairing
