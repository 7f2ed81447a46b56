// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "occt/border_graph.h"

namespace fairing::occt {

/// How much a loop turns to the left within the faces beside it, seen against their normals with
/// the hole to the left, radians: 2 pi round a flat hole, -2 pi round a flat sheet, 0 round the
/// mouth of an open box. Edges without a face count as straight.
[[nodiscard]] double turningAlong(const ShapeIndex& index,
                                  const BorderGraph& graph,
                                  const std::vector<LoopEdge>& loop);

}  // namespace fairing::occt
