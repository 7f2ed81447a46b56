// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/guidance.h"

#include <cmath>
#include <string>

namespace fairing::energy {
namespace {

bool isWeight(double value) {
  return std::isfinite(value) && value >= 0.0;
}
bool isPositive(double value) {
  return std::isfinite(value) && value > 0.0;
}

std::optional<Error> wrongHandle(const NormalHandle& handle, std::size_t number) {
  if (!isWeight(handle.weight))
    return Error{.code = ErrorCode::WeightNegative, .value = handle.weight, .detail = "handle"};
  if (!isPositive(handle.radius))
    return Error{.code = ErrorCode::WeightNegative, .value = handle.radius, .detail = "radius"};
  if (!handle.point.allFinite() || !handle.normal.allFinite())
    return Error{.code = ErrorCode::NotFinite};
  if (!(handle.normal.norm() > 0.0))
    return Error{.code = ErrorCode::NormalZero,
                 .where = handle.point,
                 .value = static_cast<double>(number),
                 .detail = "handle"};
  return std::nullopt;
}

std::optional<Error> wrongCurve(const NormalCurve& curve, std::size_t number) {
  if (curve.points.empty() || curve.points.size() != curve.normals.size())
    return Error{.code = ErrorCode::CurveNormals,
                 .value = static_cast<double>(number),
                 .detail = std::to_string(curve.normals.size()) + " of " +
                           std::to_string(curve.points.size())};
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const NormalHandle there{curve.points[k], curve.normals[k], curve.weight, curve.radius};
    if (auto wrong = wrongHandle(there, number)) {
      if (wrong->code == ErrorCode::NormalZero) wrong->detail = "curve";
      return wrong;
    }
  }
  return std::nullopt;
}

std::optional<Error> wrongGrid(const DiscreteGuidance& grid) {
  const Eigen::Index count = Eigen::Index(grid.n + 1) * (grid.m + 1);
  if (grid.n < 1 || grid.m < 1 || grid.normals.rows() != count || grid.points.rows() != count ||
      grid.lambda.size() != count || grid.gamma.size() != count)
    return Error{.code = ErrorCode::FieldSize,
                 .value = static_cast<double>(grid.normals.rows()),
                 .detail = std::to_string(grid.n) + " x " + std::to_string(grid.m)};
  if (!grid.normals.allFinite() || !grid.points.allFinite())
    return Error{.code = ErrorCode::NotFinite};
  for (Eigen::Index k = 0; k < count; ++k) {
    for (const double weight : {grid.lambda[k], grid.gamma[k]})
      if (!isWeight(weight))
        return Error{.code = ErrorCode::WeightNegative, .value = weight, .detail = "field"};
    if (grid.lambda[k] > 0.0 && !(grid.normals.row(k).norm() > 0.0))
      return Error{
          .code = ErrorCode::NormalZero, .value = static_cast<double>(k + 1), .detail = "field"};
  }
  return std::nullopt;
}

}  // namespace

Guidance weighingOne(Guidance guidance) {
  guidance.lambda = guidance.gamma = 1.0;
  return guidance;
}

std::optional<Error> validate(const Guidance& guidance) {
  if (!isWeight(guidance.lambda))
    return Error{.code = ErrorCode::WeightNegative, .value = guidance.lambda, .detail = "lambda"};
  if (!isWeight(guidance.gamma))
    return Error{.code = ErrorCode::WeightNegative, .value = guidance.gamma, .detail = "gamma"};
  for (std::size_t k = 0; k < guidance.handles.size(); ++k)
    if (auto wrong = wrongHandle(guidance.handles[k], k + 1)) return wrong;
  for (std::size_t k = 0; k < guidance.curves.size(); ++k)
    if (auto wrong = wrongCurve(guidance.curves[k], k + 1)) return wrong;
  if (guidance.discrete)
    if (auto wrong = wrongGrid(*guidance.discrete)) return wrong;
  if (guidance.continuous && !guidance.continuous->normals.poles.allFinite())
    return Error{.code = ErrorCode::NotFinite};
  return std::nullopt;
}

}  // namespace fairing::energy
