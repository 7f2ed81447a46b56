// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/direction_support.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace fairing::occt {
namespace {

using boundary::BoundarySide;
using Eigen::Vector3d;

constexpr int kSamples = 33;
/// A direction closer to the edge than this (sine of the angle, about 1 degree) spans no plane.
constexpr double kAlong = 0.0175;
/// An edge in its symmetry plane leaves it by no more than this share of its size.
constexpr double kInPlane = 1e-5;
/// A cosine below this does not tell the sense of a direction.
constexpr double kTells = 0.1;

/// Where the side is a multiple of the direction, or leaves its plane.
std::optional<Error> misfit(const BoundarySide& side, const EdgeDirection& given) {
  const Vector3d direction = given.direction.normalized();
  const Vector3d origin = side.ribbon.curve(0.0).point;
  double size = 0.0;
  Error off{.code = ErrorCode::EdgeOffPlane, .edge = side.edge};
  for (int i = 0; i < kSamples; ++i) {
    const auto sample = side.ribbon.curve(double(i) / (kSamples - 1));
    const Vector3d tangent = sample.derivative.normalized();
    if (!(tangent.cross(direction).norm() > kAlong)) {
      return Error{.code = ErrorCode::DirectionAlongEdge, .edge = side.edge, .where = sample.point};
    }
    size = std::max(size, (sample.point - origin).norm());
    const double height = std::abs((sample.point - origin).dot(direction));
    if (height > off.value) {
      off.value = height;
      off.where = sample.point;
    }
  }
  const bool leaves = given.kind == EdgeDirection::Kind::Symmetry && off.value > kInPlane * size;
  return leaves ? std::optional(off) : std::nullopt;
}

Vector3d centreOf(const std::vector<BoundarySide>& sides) {
  Vector3d sum = Vector3d::Zero();
  for (const BoundarySide& side : sides) {
    for (double t : {0.125, 0.375, 0.625, 0.875}) sum += side.ribbon.curve(t).point;
  }
  return sum / double(4 * sides.size());
}

/// The direction in the sense that points into the hole.
Vector3d inward(const std::vector<BoundarySide>& sides, std::size_t k, Vector3d direction) {
  direction.normalize();
  const std::size_t n = sides.size();
  const auto& before = sides[(k + n - 1) % n].ribbon;
  const auto& after = sides[(k + 1) % n].ribbon;
  const double neighbours = direction.dot(after.curve(0.0).derivative.normalized()) -
                            direction.dot(before.curve(1.0).derivative.normalized());
  if (n > 1 && std::abs(neighbours) > kTells) return neighbours > 0.0 ? direction : -direction;
  const Vector3d across = (centreOf(sides) - sides[k].ribbon.curve(0.5).point).normalized();
  return direction.dot(across) < -kTells ? -direction : direction;
}

}  // namespace

std::optional<Error> giveDirections(const std::map<int, EdgeDirection>& directions,
                                    std::vector<BoundarySide>& sides) {
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto given = directions.find(sides[k].edge);
    if (given == directions.end()) continue;
    if (const auto error = misfit(sides[k], given->second)) return error;
    const Vector3d direction = inward(sides, k, given->second.direction);
    sides[k].supportDeviation = 0.0;
    sides[k].ribbon.support = [curve = sides[k].ribbon.curve, direction](double t) {
      const auto sample = curve(t);
      return boundary::SupportSample{.point = sample.point,
                                     .normal = sample.derivative.cross(direction).normalized()};
    };
  }
  return std::nullopt;
}

}  // namespace fairing::occt
