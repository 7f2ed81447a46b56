// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "core/boundary/boundary_loop.h"
#include "core/height_field/plane_frame.h"

namespace fairing::height_field {

/// A loop seen in a plane, as a fine polygon in the frame's units.
struct ProjectedLoop {
  std::vector<Eigen::Vector2d> points;  ///< closed: the first follows the last
  std::vector<int> sides;               ///< of the loop, on which points[k] lies
  Eigen::AlignedBox2d box;
  double area = 0.0;  ///< positive where it runs counter-clockwise

  [[nodiscard]] bool contains(const Eigen::Vector2d& point) const;
};

[[nodiscard]] ProjectedLoop projectLoop(const boundary::BoundaryLoop& loop,
                                        const PlaneFrame& frame);

/// The side on which the projected loop crosses itself or stands still, if it does.
[[nodiscard]] std::optional<int> crossing(const ProjectedLoop& loop);

}  // namespace fairing::height_field
