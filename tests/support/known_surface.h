// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>

#include "core/spline/bspline_surface.h"
#include "support/jet2.h"

namespace fairing::testing {

/// A surface given by a formula: position and partial derivatives up to order two.
using KnownSurface = std::function<spline::SurfaceJet(double u, double v)>;

/// Three coordinates as jets, for formulas.
using JetPoint = std::array<Jet2, 3>;

/// The surface of a formula `JetPoint formula(const Jet2& u, const Jet2& v)`.
template <class Formula>
[[nodiscard]] KnownSurface surfaceOf(Formula formula) {
  return [formula](double u, double v) {
    const JetPoint p = formula(Jet2::alongU(u), Jet2::alongV(v));
    const auto pick = [&](double Jet2::* member) {
      return Eigen::Vector3d(p[0].*member, p[1].*member, p[2].*member);
    };
    return spline::SurfaceJet{pick(&Jet2::value),
                              pick(&Jet2::u),
                              pick(&Jet2::v),
                              pick(&Jet2::uu),
                              pick(&Jet2::uv),
                              pick(&Jet2::vv)};
  };
}

/// z = f(x, y), `Jet2 height(const Jet2& x, const Jet2& y)`.
template <class Height>
[[nodiscard]] KnownSurface heightField(Height height) {
  return surfaceOf([height](const Jet2& x, const Jet2& y) { return JetPoint{x, y, height(x, y)}; });
}

/// Unit normal, u x v.
[[nodiscard]] Eigen::Vector3d normalOf(const spline::SurfaceJet& jet);
/// The second fundamental form as a symmetric form in space: II(a, b) = a' S b for tangent a, b.
[[nodiscard]] Eigen::Matrix3d secondFormOf(const spline::SurfaceJet& jet);

[[nodiscard]] KnownSurface plane();
/// Longitude u, latitude v; the normal points outwards.
[[nodiscard]] KnownSurface sphere(double radius);
/// Angle u about the z axis, height v; the normal points outwards.
[[nodiscard]] KnownSurface cylinder(double radius);
/// Angle u about the z axis, angle v of the tube; the normal points outwards.
[[nodiscard]] KnownSurface torus(double radius, double tube);
/// z = steepness (x^2 - y^2).
[[nodiscard]] KnownSurface saddle(double steepness);
/// A smooth height field no polynomial of low degree reproduces.
[[nodiscard]] KnownSurface waves();
[[nodiscard]] KnownSurface surfaceOf(const spline::BsplineSurface& surface);

}  // namespace fairing::testing
