// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/departure_check.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/angle.h"

namespace fairing {
namespace {

using boundary::BoundarySide;
using boundary::Departure;
using Eigen::Vector3d;

constexpr int kSamples = 33;
constexpr double kLeastSine = 0.087;  // 5 degrees between the edge and the iso-curves

std::optional<Error> isoRunsAlong(const BoundarySide& side) {
  for (int i = 0; i < kSamples; ++i) {
    const double t = (i + 0.5) / kSamples;
    const boundary::SupportSample support = side.ribbon.support(t);
    if (support.singular) continue;
    const boundary::CurveSample curve = side.ribbon.curve(t);
    if (support.iso.cross(curve.derivative.normalized()).norm() < kLeastSine)
      return Error{ErrorCode::DepartureAlongEdge, side.edge, side.face, curve.point};
  }
  return std::nullopt;
}

// An end that follows something leaves a side as that does; as the side asks or not at all.
std::optional<Error> endAgainstSide(const BoundarySide& side, const BoundarySide& end, bool atEnd) {
  constexpr double kSameDirection = 0.05;  // degrees, as at the corners of tangent sides
  const double t = atEnd ? 1.0 : 0.0;
  const boundary::SupportSample support = side.ribbon.support(t);
  if (support.singular) return std::nullopt;
  const boundary::CurveSample curve = side.ribbon.curve(t);
  const Vector3d left = support.normal.cross(curve.derivative).normalized();
  Vector3d leaving = end.ribbon.curve(atEnd ? 0.0 : 1.0).derivative.normalized();
  if (!atEnd) leaving = -leaving;
  Vector3d asked = side.departure == Departure::Iso ? support.iso : left;
  if (asked.dot(left) < 0.0) asked = -asked;
  if (side.leaving == boundary::Leaving::Backwards) asked = -asked;
  const double angle = angleBetween(leaving, asked);
  const double allowed = side.departure == Departure::Free ? 90.0 : kSameDirection;
  if (angle <= allowed) return std::nullopt;
  return Error{ErrorCode::EndAgainstSide, side.edge, side.face, curve.point, angle};
}

}  // namespace

std::optional<Error> checkDepartures(const boundary::ChainPair& pair, const BlendOptions& options) {
  for (std::size_t k = 0; k < pair.sides.sides.size(); ++k) {
    if (pair.isEnd(k)) continue;
    const std::size_t chain = pair.chainOf(k);
    const BoundarySide& side = pair.sides.sides[k];
    if (pair.closed && options.reach.varies(chain))
      return Error{.code = ErrorCode::ReachVariesRound, .edge = side.edge};
    const bool free = options.departure[chain] == Departure::Free &&
                      options.leaving[chain] == boundary::Leaving::Onwards;
    if (free) continue;
    if (!side.isTangent()) return Error{.code = ErrorCode::DepartureNotTangent, .edge = side.edge};
    if (options.departure[chain] == Departure::Iso)
      if (const auto along = isoRunsAlong(side)) return along;
    BoundarySide asked = side;
    asked.departure = options.departure[chain];
    asked.leaving = options.leaving[chain];
    const std::size_t next = pair.sides.next(k), previous = pair.sides.previous(k);
    if (pair.isEnd(next))
      if (const auto against = endAgainstSide(asked, pair.sides.sides[next], true)) return against;
    if (pair.isEnd(previous))
      if (const auto against = endAgainstSide(asked, pair.sides.sides[previous], false))
        return against;
  }
  return std::nullopt;
}

}  // namespace fairing
