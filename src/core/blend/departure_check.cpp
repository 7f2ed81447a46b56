// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/departure_check.h"

#include <Eigen/Geometry>

namespace fairing {
namespace {

using boundary::BoundarySide;
using boundary::Departure;

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

}  // namespace

std::optional<Error> checkDepartures(const boundary::ChainPair& pair, const BlendOptions& options) {
  for (std::size_t k = 0; k < pair.sides.sides.size(); ++k) {
    const std::size_t chain = pair.chainOf(k);
    const BoundarySide& side = pair.sides.sides[k];
    if (pair.closed && options.reach.varies(chain))
      return Error{.code = ErrorCode::ReachVariesRound, .edge = side.edge};
    const bool free = options.departure[chain] == Departure::Free &&
                      options.leaving[chain] == boundary::Leaving::Onwards;
    if (free) continue;
    if (!side.isTangent()) return Error{.code = ErrorCode::DepartureNotTangent, .edge = side.edge};
    if (options.departure[chain] != Departure::Iso) continue;
    if (const auto along = isoRunsAlong(side)) return along;
  }
  return std::nullopt;
}

}  // namespace fairing
