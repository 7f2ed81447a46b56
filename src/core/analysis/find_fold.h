// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <vector>

#include "core/spline/bspline_surface.h"

namespace fairing::analysis {

/// Where a surface turns over: its normal u x v against itself across a line where it vanishes.
struct Fold {
  Eigen::Vector3d where;  ///< the middle of what is turned over
  double share = 0.0;     ///< of the patches' area, 0 to 1
};

/// The part of patches whose normal is against that of the larger part of its own patch, by about
/// `samples` normals in all: neighbours that differ by more than 90 degrees lie on either side of a
/// fold.
[[nodiscard]] std::optional<Fold> findFold(const std::vector<spline::BsplineSurface>& patches,
                                           int samples = 1600);

}  // namespace fairing::analysis
