// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/cut_loop.h"

#include <algorithm>
#include <limits>

#include "core/base/assert.h"
#include "core/base/bisect.h"
#include "core/boundary/edge_chain.h"

namespace fairing::boundary {
namespace {

// Cuts closer than this to an edge's end are at its end.
constexpr double kAtEnd = 1e-9;

// Of the places looked at on every side before the nearest one is refined.
constexpr int kSamples = 64;
constexpr int kHalvings = 60;

// Where the distance to a point is least on the stretch about one sample, by the sign of its
// derivative.
double refined(const Ribbon& ribbon, const Eigen::Vector3d& point, double t) {
  const double low = std::max(0.0, t - 1.0 / kSamples), high = std::min(1.0, t + 1.0 / kSamples);
  return bisect(low, high, kHalvings, [&](double place) {
    const CurveSample at = ribbon.curve(place);
    return at.derivative.dot(point - at.point) > 0.0;
  });
}

}  // namespace

Eigen::Vector3d pointAt(const BoundaryLoop& loop, const LoopPlace& place) {
  return loop.sides[place.side].ribbon.curve(place.t).point;
}

LoopPlace nearestPlace(const BoundaryLoop& loop, const Eigen::Vector3d& point) {
  LoopPlace best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t side = 0; side < loop.sides.size(); ++side)
    for (int k = 0; k <= kSamples; ++k) {
      const LoopPlace place{side, static_cast<double>(k) / kSamples};
      const double distance = (pointAt(loop, place) - point).norm();
      if (distance < least) least = distance, best = place;
    }
  best.t = refined(loop.sides[best.side].ribbon, point, best.t);
  return best;
}

std::vector<Stretch> stretchesBetween(const BoundaryLoop& loop, LoopPlace from, LoopPlace to) {
  std::vector<Stretch> result;
  std::size_t edge = from.side;
  double start = from.t;
  if (from.side == to.side && from.t < to.t) return {{from.side, from.t, to.t, 0.0, 1.0}};
  do {
    if (1.0 - start > kAtEnd) result.push_back({edge, start, 1.0, 0.0, 1.0});
    edge = loop.next(edge);
    start = 0.0;
  } while (edge != to.side);
  if (to.t > kAtEnd) result.push_back({to.side, 0.0, to.t, 0.0, 1.0});
  return result;
}

Result<CutLoop> cutLoop(const BoundaryLoop& loop,
                        const std::vector<LoopPlace>& cuts,
                        int mostPoles) {
  CutLoop cut;
  std::vector<BoundarySide> sides;
  std::vector<std::size_t> further;
  std::size_t k = 0;
  for (const auto& [first, end] : loop.chains()) {
    const std::size_t start = k;
    while (k < cuts.size() && cuts[k].side < end) ++k;
    FAIRING_ASSERT(k >= start + 2);
    if (start > 0) further.push_back(sides.size());
    for (std::size_t i = start; i < (loop.isOpen() ? k - 1 : k); ++i) {
      const auto stretches = stretchesBetween(loop, cuts[i], cuts[i + 1 < k ? i + 1 : start]);
      FAIRING_ASSERT(!stretches.empty());
      EdgeChain side = sideOfStretches(loop, stretches, mostPoles);
      sides.push_back(std::move(side.side));
      cut.stretches.push_back(std::move(side.stretches));
    }
  }
  auto made = loop.isOpen() ? makeOpenChains(std::move(sides), std::move(further))
                            : makeLoop(std::move(sides), std::move(further));
  if (!made) return fail(made.error());
  cut.loop = std::move(*made);
  cut.loop.diagonal = loop.diagonal;
  return cut;
}

}  // namespace fairing::boundary
