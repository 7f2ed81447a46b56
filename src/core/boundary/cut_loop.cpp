// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/cut_loop.h"

#include "core/base/assert.h"
#include "core/boundary/edge_chain.h"

namespace fairing::boundary {
namespace {

// Cuts closer than this to an edge's end are at its end.
constexpr double kAtEnd = 1e-9;

}  // namespace

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
    if (start > 0) further.push_back(start);
    for (std::size_t i = start; i < k; ++i) {
      const auto stretches = stretchesBetween(loop, cuts[i], cuts[i + 1 < k ? i + 1 : start]);
      FAIRING_ASSERT(!stretches.empty());
      EdgeChain side = sideOfStretches(loop, stretches, mostPoles);
      sides.push_back(std::move(side.side));
      cut.stretches.push_back(std::move(side.stretches));
    }
  }
  auto made = makeLoop(std::move(sides), std::move(further));
  if (!made) return fail(made.error());
  cut.loop = std::move(*made);
  cut.loop.diagonal = loop.diagonal;
  return cut;
}

}  // namespace fairing::boundary
