// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <functional>

namespace fairing {

/// A point, or a curve, that the patches must pass through.
struct InnerConstraint {
  /// A point of the curve, t in [0, 1], mm; a point is a curve that does not move.
  std::function<Eigen::Vector3d(double t)> at;
  bool isPoint = true;
};

}  // namespace fairing
