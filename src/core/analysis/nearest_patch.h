// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/analysis/closest_point.h"

namespace fairing::analysis {

/// The point of several patches that is nearest to a given one.
struct PatchFoot {
  int patch = 0;
  SurfaceFoot foot;
};

/// Looks at a grid over every patch and refines the nearest places by Newton's method.
[[nodiscard]] PatchFoot nearestPatch(const std::vector<spline::BsplineSurface>& patches,
                                     const Eigen::Vector3d& point);

}  // namespace fairing::analysis
