// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/spline/closest_point.h"

namespace fairing::spline {

/// The point of several patches that is nearest to a given one.
struct PatchFoot {
  int patch = 0;
  SurfaceFoot foot;
};

/// Finds nearest points of patches, which must outlive it: looks at a grid over every patch and
/// refines the nearest places by Newton's method.
class NearestPatch {
 public:
  explicit NearestPatch(const std::vector<BsplineSurface>& patches);
  [[nodiscard]] PatchFoot to(const Eigen::Vector3d& point) const;

 private:
  struct Place {
    Eigen::Vector3d point;
    int patch;
    double u, v;
  };

  const std::vector<BsplineSurface>& patches_;
  std::vector<Place> grid_;
};

}  // namespace fairing::spline
