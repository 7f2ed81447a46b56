// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/base/result.h"
#include "occt/border_graph.h"
#include "occt/picks.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// The loop the picks mean, head to tail, the hole to its left, starting at its lowest edge number:
/// the same whatever the order of the picks and whichever edges of the loop they are. The picked
/// edges are the loop if they close by themselves; else the border is followed from the lowest one.
/// Where more than two candidates meet, the next edge is the picked one, or the one that bounds the
/// same gap between the faces.
[[nodiscard]] Result<std::vector<LoopEdge>> traceLoop(const ShapeIndex& index,
                                                      const BorderGraph& graph,
                                                      const Picks& picks);

/// The edge numbers of traceLoop().
[[nodiscard]] Result<std::vector<int>> findLoop(const ShapeIndex& index, const Picks& picks);

/// A loop that runs with the hole to the left for most of the length that has a say, and starts at
/// its lowest edge number.
[[nodiscard]] std::vector<LoopEdge> canonical(const BorderGraph& graph, std::vector<LoopEdge> loop);

}  // namespace fairing::occt
