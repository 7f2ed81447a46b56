// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/ring_star.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "core/layout/loop_picture.h"

namespace fairing::layout {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// The way into the gap at a place of a side.
Vector3d departure(const boundary::BoundarySide& side, double t) {
  if (!side.ribbon.hasSupport()) return Vector3d::Zero();
  return side.ribbon.support(t).normal.cross(side.ribbon.curve(t).derivative).normalized();
}

}  // namespace

RingMesh::RingMesh(std::vector<Vector3d> points, int firstInside) : points_(std::move(points)) {
  mesh_.inside.assign(points_.size(), 0);
  std::fill(mesh_.inside.begin() + firstInside, mesh_.inside.end(), 1);
}

void RingMesh::addStar(const StarBorder& border, int centre) {
  const auto& [vertices, sides] = border;
  const std::size_t n = vertices.size();
  std::vector<Vector3d> spokeEnds;
  for (std::size_t k = 0; k < n; k += 2) {
    mesh_.quads.push_back({{vertices[k], vertices[k + 1], vertices[(k + 2) % n], centre},
                           {sides[k], sides[k + 1], -1, -1}});
    spokeEnds.push_back(points_[static_cast<std::size_t>(vertices[k])]);
  }
  const auto picture = pictureOf(spokeEnds, points_[static_cast<std::size_t>(centre)]);
  for (std::size_t k = 0; k < picture.size(); ++k)
    show(centre, vertices[2 * k], picture[k].normalized());
}

void RingMesh::showCrossing(int vertex,
                            int before,
                            int after,
                            const std::vector<int>& left,
                            const std::vector<int>& right) {
  show(vertex, before, -Vector2d::UnitX());
  show(vertex, after, Vector2d::UnitX());
  for (const int other : left) show(vertex, other, Vector2d::UnitY());
  for (const int other : right) show(vertex, other, -Vector2d::UnitY());
}

// From the far end nothing but the length is asked for where that lies on a chain.
void RingMesh::show(int from, int to, const Vector2d& direction) {
  const double length =
      (points_[static_cast<std::size_t>(from)] - points_[static_cast<std::size_t>(to)]).norm();
  mesh_.ways[{from, to}] = length * direction;
  mesh_.ways.try_emplace({to, from}, -length * direction);
}

Vector3d middleOfWay(const boundary::BoundarySide& from,
                     double t,
                     const boundary::BoundarySide& to) {
  const Vector3d a = from.ribbon.curve(t).point, b = to.ribbon.curve(0.0).point;
  const Vector3d leaving = departure(from, t) + departure(to, 0.0);
  return 0.5 * (a + b) + 0.125 * (a - b).norm() * leaving;
}

}  // namespace fairing::layout
