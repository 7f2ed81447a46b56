// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <BRepAdaptor_Surface.hxx>
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fairing::occt {

/// A face's surface at (u, v): position and partial derivatives up to order two. Orientation is not
/// applied.
struct SurfacePoint {
  double u = 0.0, v = 0.0;
  Eigen::Vector3d point, su, sv, suu, suv, svv;

  /// Su x Sv, not of unit length.
  [[nodiscard]] Eigen::Vector3d cross() const { return su.cross(sv); }
  /// Whether the surface has a normal here that keeps half its digits.
  [[nodiscard]] bool isRegular() const;
  /// The second fundamental form against a unit normal, as a symmetric form in space: a' * form * b
  /// = II(a, b) for tangent vectors a and b, with II(a, b) = -dn(a) . b.
  [[nodiscard]] Eigen::Matrix3d secondForm(const Eigen::Vector3d& normal) const;
  /// The step in (u, v) that a small tangent step is.
  [[nodiscard]] Eigen::Vector2d parametersOf(const Eigen::Vector3d& step) const;
};

[[nodiscard]] SurfacePoint evaluate(const BRepAdaptor_Surface& surface, double u, double v);

using DomainBox = Eigen::AlignedBox2d;

/// The foot of `target` on the surface by Newton's method from `start`, kept inside `domain`. The
/// distance never grows.
[[nodiscard]] SurfacePoint footFrom(const BRepAdaptor_Surface& surface,
                                    const Eigen::Vector3d& target,
                                    SurfacePoint start,
                                    const DomainBox& domain);

}  // namespace fairing::occt
