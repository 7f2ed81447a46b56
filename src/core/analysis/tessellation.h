// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/spline/bspline_surface.h"

namespace fairing::analysis {

/// Triangles for a preview: one vertex per grid point, with its normal.
struct Mesh {
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> points, normals;
  Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> triangles;
};

/// A (divisions + 1)^2 grid per patch, counter-clockwise about the patch's normal, or clockwise
/// where `reversed`.
[[nodiscard]] Mesh tessellate(const std::vector<spline::BsplineSurface>& patches,
                              const std::vector<bool>& reversed,
                              int divisions);

}  // namespace fairing::analysis
