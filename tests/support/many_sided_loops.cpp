// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/many_sided_loops.h"

#include <cmath>
#include <numbers>

namespace fairing::testing {
namespace {

using Eigen::Vector2d;
constexpr double kPi = std::numbers::pi;

Vector2d round(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// An arc, faster at its start than at its end by the share `uneven`.
Trace arc(double radius, double from, double sweep, double uneven) {
  return [=](double t) {
    const double angle = from + sweep * (t + uneven * t * (1.0 - t));
    const double rate = sweep * (1.0 + uneven * (1.0 - 2.0 * t));
    return TracePoint{round(radius, angle), rate * round(radius, angle + 0.5 * kPi)};
  };
}

}  // namespace

Sides polygonOn(const KnownSurface& surface, int corners, double radius, double turned) {
  const auto corner = [=](int k) { return round(radius, turned + 2.0 * kPi * k / corners); };
  Sides sides;
  for (int k = 0; k < corners; ++k)
    sides.push_back(sideOn(surface, line(corner(k), corner((k + 1) % corners)), k));
  return sides;
}

Sides circleOn(const KnownSurface& surface, double radius, double from) {
  return {sideOn(surface, arc(radius, from, 2.0 * kPi, 0.0), 0)};
}

Sides halfCirclesOn(const KnownSurface& surface, double radius) {
  return {sideOn(surface, arc(radius, 0.0, kPi, 0.3), 0),
          sideOn(surface, arc(radius, kPi, kPi, -0.2), 1)};
}

Sides sphereOctant(double radius) {
  const Sides equator{sideOn(sphere(radius), line({0.0, 0.0}, {0.5 * kPi, 0.0}), 0)};
  Sides sides;
  for (int k = 0; k < 3; ++k) {
    const Eigen::AngleAxisd turn(2.0 * kPi * k / 3.0, Eigen::Vector3d::Ones().normalized());
    sides.push_back(moved(equator, Eigen::Affine3d(turn)).front());
    sides.back().edge = sides.back().face = k + 1;
  }
  return sides;
}

Sides asking(Sides sides, Continuity continuity) {
  for (auto& side : sides) side.continuity = continuity;
  return sides;
}

Vector2d onEdge(const spline::BsplineSurface& patch, layout::PatchEdge edge, double t) {
  const double width = patch.u.last(), height = patch.v.last();
  switch (edge) {
    case layout::PatchEdge::South:
      return {t * width, 0.0};
    case layout::PatchEdge::East:
      return {width, t * height};
    case layout::PatchEdge::North:
      return {(1.0 - t) * width, height};
    case layout::PatchEdge::West:
      break;
  }
  return {0.0, (1.0 - t) * height};
}

}  // namespace fairing::testing
