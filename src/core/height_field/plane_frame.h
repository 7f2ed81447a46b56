// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>

#include "core/boundary/boundary_loop.h"

namespace fairing::height_field {

/// A plane with two axes in it, right-handed with its normal: where heights are measured from.
/// Coordinates are in units of the frame, so that they are about 1 at every size of model.
struct PlaneFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: u, v, normal; orthonormal
  double unit = 1.0;                                   ///< mm

  /// Plane coordinates and height of a point: (u, v, h).
  [[nodiscard]] Eigen::Vector3d coordinates(const Eigen::Vector3d& point) const {
    return axes.transpose() * (point - origin) / unit;
  }
  /// Components of a unit vector along u, v and the normal.
  [[nodiscard]] Eigen::Vector3d components(const Eigen::Vector3d& direction) const {
    return axes.transpose() * direction;
  }
  [[nodiscard]] Eigen::Vector3d point(const Eigen::Vector3d& coordinates) const {
    return origin + unit * (axes * coordinates);
  }
};

/// A surface over the plane is as steep as this where it meets the loop.
struct Steepness {
  double degrees = 0.0;  ///< largest angle between the tangent planes asked for and the plane
  int edge = 0;          ///< the edge where
  Eigen::Vector3d where = Eigen::Vector3d::Zero();
};

/// How steep the sides are over the plane: the support normals of sides that ask for them, and the
/// edges themselves.
[[nodiscard]] Steepness steepness(const boundary::BoundaryLoop& loop, const PlaneFrame& frame);

/// The plane the loop is best seen from: perpendicular to its area vector, or, where that is steep
/// for the supports, to the middle of their normals. Seen against its normal the loop runs
/// counter-clockwise. The axes are those of the loop's smallest rectangle, u the longer one; the
/// origin is its middle, the unit the root of the area it encloses. Fails with LayoutUnfit where
/// the loop encloses no area.
[[nodiscard]] Result<PlaneFrame> choosePlane(const boundary::BoundaryLoop& loop);

}  // namespace fairing::height_field
