// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace fairing {

inline constexpr double kDegrees = 180.0 / std::numbers::pi;  ///< in a radian

/// Between two vectors other than zero, degrees, 0 to 180; exact to rounding at either end.
[[nodiscard]] inline double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * kDegrees;
}

/// Between the lines they span, degrees, 0 to 90.
[[nodiscard]] inline double lineAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * kDegrees;
}

}  // namespace fairing
