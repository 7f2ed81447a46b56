// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/loop_corners.h"

#include <algorithm>
#include <cmath>
namespace fairing::layout {
namespace {

// Edges whose tangents differ by less (degrees) are one side: a spline through both rounds such a
// kink off by less than CAD tolerances.
constexpr double kSmooth = 0.05;
// Places closer to an end of a side than this, in its parameter, are the end.
constexpr double kAtEnd = 1e-9;

CornerRole roleOf(const boundary::Corner& corner) {
  if (corner.angle >= 180.0 - kSmooth) return CornerRole::Smooth;
  return corner.insideAngle <= boundary::kWidestCorner ? CornerRole::Corner : CornerRole::Split;
}

}  // namespace

std::vector<CornerRole> cornerRoles(const boundary::BoundaryLoop& loop) {
  std::vector<CornerRole> roles;
  for (const boundary::Corner& corner : loop.corners) roles.push_back(roleOf(corner));
  return roles;
}

LoopLength::LoopLength(const boundary::BoundaryLoop& loop, std::size_t first, std::size_t end)
    : first_(first), starts_{0.0} {
  for (std::size_t k = first; k < end; ++k) {
    arcs_.emplace_back(loop.sides[k].ribbon, 0.0, 1.0);
    starts_.push_back(starts_.back() + arcs_.back().length());
  }
}

double LoopLength::upTo(const boundary::LoopPlace& place) const {
  return upTo(place.side) + arcs_[place.side - first_].lengthUpTo(place.t);
}

boundary::LoopPlace LoopLength::placeAt(double length) const {
  length -= whole() * std::floor(length / whole());
  const auto above = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, length);
  const auto side = static_cast<std::size_t>(above - starts_.begin()) - 1;
  const double t = arcs_[side].parameterAt(length - starts_[side]);
  if (t < kAtEnd) return {first_ + side, 0.0};
  if (t > 1.0 - kAtEnd) return {first_ + (side + 1) % arcs_.size(), 0.0};
  return {first_ + side, t};
}

std::optional<boundary::LoopPlace> spokeEnd(const LoopLength& lengths,
                                            const std::vector<std::size_t>& splits,
                                            double middle) {
  if (splits.size() > 1) return std::nullopt;
  return splits.empty() ? lengths.placeAt(middle) : boundary::LoopPlace{splits.front(), 0.0};
}

}  // namespace fairing::layout
