// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <gmock/gmock.h>

#include <Eigen/Core>

#include "core/base/error.h"

namespace fairing::testing {

/// A vector or matrix every entry of which is within `tolerance` of the expected one.
MATCHER_P2(IsNear, expected, tolerance, "") {
  if (arg.rows() != expected.rows() || arg.cols() != expected.cols()) {
    *result_listener << "has another size";
    return false;
  }
  const double worst = (arg - expected).cwiseAbs().maxCoeff();
  *result_listener << "which is off by " << worst;
  return worst <= tolerance;  // false for NaN
}

/// A Result that failed with this code.
MATCHER_P(FailsWith, code, "") {
  if (arg.has_value()) {
    *result_listener << "which succeeded";
    return false;
  }
  *result_listener << "which failed with code " << static_cast<int>(arg.error().code);
  return arg.error().code == code;
}

}  // namespace fairing::testing
