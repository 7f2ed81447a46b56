// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/fill_options.h"

#include <cmath>

namespace fairing {
namespace {

constexpr int kLeastDegree = 3, kLargestDegree = 9;
constexpr int kLeastPoles = 16;

bool isWeight(double value) {
  return std::isfinite(value) && value >= 0.0;
}
bool isPositive(double value) {
  return std::isfinite(value) && value > 0.0;
}

Error error(ErrorCode code, double value, std::string detail = {}) {
  return {code, 0, 0, std::nullopt, value, std::move(detail)};
}

}  // namespace

std::optional<Error> validate(const FillOptions& options) {
  const Tolerance& t = options.tolerance;
  if (t.gap != 0.0 && !isPositive(t.gap)) return error(ErrorCode::ToleranceNotPositive, t.gap);
  if (!isPositive(t.relativeGap)) return error(ErrorCode::ToleranceNotPositive, t.relativeGap);
  if (!isPositive(t.angle)) return error(ErrorCode::AngleNotPositive, t.angle);
  if (!isPositive(t.cornerAngle)) return error(ErrorCode::AngleNotPositive, t.cornerAngle);
  const energy::Guidance& g = options.guidance;
  if (!isWeight(g.lambda)) return error(ErrorCode::WeightNegative, g.lambda, "lambda");
  if (!isWeight(g.gamma)) return error(ErrorCode::WeightNegative, g.gamma, "gamma");
  for (const energy::NormalHandle& handle : g.handles) {
    if (!isWeight(handle.weight)) return error(ErrorCode::WeightNegative, handle.weight, "handle");
    if (!isPositive(handle.radius))
      return error(ErrorCode::WeightNegative, handle.radius, "radius");
  }
  if (options.degree != 0 && (options.degree < kLeastDegree || options.degree > kLargestDegree))
    return error(ErrorCode::DegreeOutOfRange, options.degree);
  if (options.maxPoles < kLeastPoles) return error(ErrorCode::ControlPointLimit, options.maxPoles);
  return std::nullopt;
}

}  // namespace fairing
