// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/base/result.h"
#include "occt/border_graph.h"
#include "occt/picks.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// One edge of a loop and the way the loop runs along it.
struct LoopEdge {
  int border = 0;  ///< position in BorderGraph::edges()
  Direction direction = Direction::Forward;
};

/// A loop of free edges.
struct Hole {
  std::vector<int> edges;      ///< FreeCAD's numbers, in order
  bool isOuterBorder = false;  ///< the rim of an open sheet rather than a hole in it
};

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

/// Every loop of free edges, by ascending lowest edge. A loop whose walk is ambiguous or does not
/// close is left out. The outer border is the loop that is about as large as its sheet and larger
/// than every other loop of that sheet.
[[nodiscard]] std::vector<Hole> findHoles(const ShapeIndex& index);

}  // namespace fairing::occt
