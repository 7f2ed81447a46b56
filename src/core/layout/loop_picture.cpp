// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/loop_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/spline/quadrature.h"

namespace fairing::layout {
namespace {

using Eigen::Vector3d;

constexpr double kLeastShare = 0.2;
constexpr int kPoints = 12;  // of a Gauss-Legendre rule a side

// Mean of the boundary over its length.
Vector3d centreOf(const boundary::BoundaryLoop& loop) {
  Vector3d sum = Vector3d::Zero();
  double length = 0.0;
  for (const boundary::BoundarySide& side : loop.sides)
    for (const auto& q : spline::gaussLegendre(kPoints, 0.0, 1.0)) {
      const boundary::CurveSample sample = side.ribbon.curve(q.parameter);
      const double share = q.weight * sample.derivative.norm();
      sum += share * sample.point;
      length += share;
    }
  return sum / length;
}

}  // namespace

std::vector<Eigen::Vector2d> pictureOf(const boundary::BoundaryLoop& loop) {
  std::vector<Vector3d> starts;
  for (const boundary::BoundarySide& side : loop.sides)
    starts.push_back(side.ribbon.curve(0.0).point);
  return pictureOf(starts, centreOf(loop));
}

std::vector<Eigen::Vector2d> pictureOf(const std::vector<Vector3d>& points,
                                       const Vector3d& centre) {
  const std::size_t n = points.size();
  std::vector<Vector3d> ways;
  for (const Vector3d& point : points) ways.push_back(point - centre);
  std::vector<double> angles;
  for (std::size_t k = 0; k < n; ++k) {
    const Vector3d &a = ways[k], &b = ways[(k + 1) % n];
    angles.push_back(std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  const double whole = 2.0 * std::numbers::pi;
  const double least =
      kLeastShare * std::accumulate(angles.begin(), angles.end(), 0.0) / static_cast<double>(n);
  for (double& angle : angles) angle = std::max(angle, least);
  const double sum = std::accumulate(angles.begin(), angles.end(), 0.0);
  std::vector<Eigen::Vector2d> picture;
  double direction = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    picture.push_back(ways[k].norm() * Eigen::Vector2d(std::cos(direction), std::sin(direction)));
    direction += angles[k] * whole / sum;
  }
  return picture;
}

}  // namespace fairing::layout
