// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fairing::testing {
namespace {

constexpr int kPlaces = 137;  // coprime to the counts that solver and report use

// The patch's parameters at a share of its border line along a side.
Eigen::Vector2d onBorder(const spline::BsplineSurface& patch, std::size_t side, double share) {
  const double w = patch.u.last(), h = patch.v.last();
  switch (side) {
    case 0:
      return {share * w, 0.0};
    case 1:
      return {w, share * h};
    case 2:
      return {(1.0 - share) * w, h};
    default:
      return {0.0, (1.0 - share) * h};
  }
}

// The share of the border line nearest to a point: golden section around a guess.
double nearestShare(const spline::BsplineSurface& patch,
                    std::size_t side,
                    const Eigen::Vector3d& point,
                    double guess) {
  const auto distance = [&](double share) {
    const Eigen::Vector2d at = onBorder(patch, side, share);
    return (patch.evaluate(at[0], at[1]) - point).squaredNorm();
  };
  double low = std::max(0.0, guess - 0.02), high = std::min(1.0, guess + 0.02);
  const double golden = std::numbers::phi - 1.0;
  for (int k = 0; k < 60; ++k) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
  }
  return 0.5 * (low + high);
}

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * 180.0 / std::numbers::pi;
}

}  // namespace

QuadDeviation deviationOf(const boundary::BoundaryLoop& loop,
                          const spline::BsplineSurface& patch,
                          std::size_t side,
                          double from,
                          double to) {
  const boundary::Ribbon& ribbon = loop.sides[side].ribbon;
  QuadDeviation worst;
  for (int k = 0; k < kPlaces; ++k) {
    const double t = from + (to - from) * (k + 0.5) / kPlaces;
    const Eigen::Vector3d point = ribbon.curve(t).point;
    const Eigen::Vector2d at = onBorder(patch, side, nearestShare(patch, side, point, t));
    const spline::SurfaceJet jet = patch.jet(at[0], at[1]);
    worst.gap = std::max(worst.gap, (jet.point - point).norm());
    if (!ribbon.hasSupport()) continue;
    const double angle = angleBetween(jet.normalVector().normalized(), ribbon.support(t).normal);
    double& zone = t < 0.02 || t > 0.98 ? worst.cornerAngle : worst.angle;
    zone = std::max(zone, angle);
  }
  return worst;
}

QuadDeviation deviationOf(const boundary::BoundaryLoop& loop, const spline::BsplineSurface& patch) {
  QuadDeviation worst;
  for (std::size_t side = 0; side < 4; ++side) {
    const QuadDeviation one = deviationOf(loop, patch, side);
    worst.gap = std::max(worst.gap, one.gap);
    worst.angle = std::max(worst.angle, one.angle);
    worst.cornerAngle = std::max(worst.cornerAngle, one.cornerAngle);
  }
  return worst;
}

double distanceFromPlane(const spline::BsplineSurface& patch,
                         const Eigen::Vector3d& point,
                         const Eigen::Vector3d& normal) {
  double worst = 0.0;
  for (int i = 0; i <= 12; ++i)
    for (int j = 0; j <= 12; ++j) {
      const Eigen::Vector3d p =
          patch.evaluate(patch.u.last() * i / 12.0, patch.v.last() * j / 12.0);
      worst = std::max(worst, std::abs(normal.normalized().dot(p - point)));
    }
  return worst;
}

}  // namespace fairing::testing
