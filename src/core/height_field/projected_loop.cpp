// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/projected_loop.h"

#include <algorithm>

namespace fairing::height_field {
namespace {

using Eigen::Vector2d;

constexpr int kFewest = 16, kMost = 480;  // points a side
constexpr std::size_t kAllPoints = 1200;
// A chord shorter than this share of its length in space stands still in the plane.
constexpr double kStandsStill = 1e-3;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool cutEachOther(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const double onC = cross(b - a, c - a), onD = cross(b - a, d - a);
  const double onA = cross(d - c, a - c), onB = cross(d - c, b - c);
  return onC * onD < 0.0 && onA * onB < 0.0;
}

}  // namespace

bool ProjectedLoop::contains(const Vector2d& point) const {
  bool inside = false;
  for (std::size_t k = 0, before = points.size() - 1; k < points.size(); before = k++) {
    const Vector2d &a = points[k], &b = points[before];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

ProjectedLoop projectLoop(const boundary::BoundaryLoop& loop, const PlaneFrame& frame) {
  const auto each = std::clamp(static_cast<int>(kAllPoints / loop.sides.size()), kFewest, kMost);
  ProjectedLoop projected;
  for (std::size_t k = 0; k < loop.sides.size(); ++k)
    for (int i = 0; i < each; ++i) {
      const auto at = loop.sides[k].ribbon.curve(static_cast<double>(i) / each);
      projected.points.emplace_back(frame.coordinates(at.point).head<2>());
      projected.sides.push_back(static_cast<int>(k));
      projected.box.extend(projected.points.back());
    }
  for (std::size_t k = 0; k < projected.points.size(); ++k)
    projected.area +=
        0.5 * cross(projected.points[k], projected.points[(k + 1) % projected.points.size()]);
  return projected;
}

std::optional<int> crossing(const ProjectedLoop& loop) {
  const std::size_t n = loop.points.size();
  const auto next = [&](std::size_t k) -> const Vector2d& { return loop.points[(k + 1) % n]; };
  const double least = kStandsStill * loop.box.diagonal().norm() / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    Eigen::AlignedBox2d reach(loop.points[i]);
    reach.extend(next(i));
    for (std::size_t j = i + 2; j < n; ++j) {
      if (j == n - 1 && i == 0) continue;
      Eigen::AlignedBox2d other(loop.points[j]);
      other.extend(next(j));
      if (!reach.intersects(other)) continue;
      if (cutEachOther(loop.points[i], next(i), loop.points[j], next(j))) return loop.sides[i];
    }
  }
  // A side that is seen as a point has no curve in the plane.
  for (std::size_t first = 0; first < n;) {
    std::size_t last = first;
    double length = 0.0;
    for (; last < n && loop.sides[last] == loop.sides[first]; ++last)
      length += (next(last) - loop.points[last]).norm();
    if (length < least) return loop.sides[first];
    first = last;
  }
  return std::nullopt;
}

}  // namespace fairing::height_field
