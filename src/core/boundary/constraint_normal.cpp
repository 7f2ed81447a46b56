// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/constraint_normal.h"

#include <Eigen/Geometry>
#include <limits>

namespace fairing::boundary {

Eigen::Vector3d constraintNormal(const Ribbon& ribbon, double t) {
  const SupportSample support = ribbon.support(t);
  if (support.singular) return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  const Eigen::Vector3d along = ribbon.curve(t).derivative;
  const double length2 = along.squaredNorm();
  if (length2 == 0.0) return support.normal;
  return (support.normal - along * (along.dot(support.normal) / length2)).normalized();
}

Eigen::Vector3d constraintNormalDerivativeAtEnd(const Ribbon& ribbon, bool atStart) {
  constexpr double kStep =
      2e-3;  // truncation about kStep^4, rounding about 1e-16 / kStep: both below 1e-10
  constexpr double kWeights[5] = {-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25};
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 5; ++k) {
    const double t = atStart ? k * kStep : 1.0 - k * kStep;
    sum += kWeights[k] * constraintNormal(ribbon, t);
  }
  return sum / (atStart ? kStep : -kStep);
}

}  // namespace fairing::boundary
