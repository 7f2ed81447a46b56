// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/energy/guidance.h"

namespace fairing::energy {

/// What guides at a place, for drawing.
struct GuideArrow {
  Eigen::Vector3d point;   ///< of the patches
  Eigen::Vector3d normal;  ///< of unit length
  double weight;           ///< of the normal, without the global one; above 0
};

/// The guide at count x count places of every patch, in the middle of equal cells; of a grid of
/// normals its own places. Where several kinds speak each has its arrow.
[[nodiscard]] std::vector<GuideArrow> guideArrows(
    const Guidance& guidance, const std::vector<spline::BsplineSurface>& patches, int count);

}  // namespace fairing::energy
