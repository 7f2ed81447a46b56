// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/read_boundary.h"

#include "occt/border_graph.h"
#include "occt/direction_support.h"
#include "occt/find_loop.h"
#include "occt/guarded.h"
#include "occt/loop_crossing.h"
#include "occt/read_side.h"

namespace fairing::occt {
Result<boundary::BoundaryLoop> readBoundary(const ShapeIndex& index, const Picks& picks) {
  return guarded([&]() -> Result<boundary::BoundaryLoop> {
    const BorderGraph graph = BorderGraph::build(index, picks);
    const auto loop = traceLoop(index, graph, picks);
    if (!loop) return fail(loop.error());
    std::vector<boundary::BoundarySide> sides;
    for (const LoopEdge& e : *loop) {
      sides.push_back(readSide(index, picks, graph.edges()[std::size_t(e.border)], e.direction));
    }
    if (const auto error = strayWish(picks, sides)) return fail(*error);
    if (const auto error = giveDirections(picks.directions, sides)) return fail(*error);
    auto made = boundary::makeLoop(std::move(sides));
    if (!made) return made;
    if (const auto error = findCrossing(*made)) return fail(*error);
    return made;
  });
}

}  // namespace fairing::occt
