// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/boundary/cut_loop.h"

namespace fairing::boundary {

/// Several edges of a loop, or stretches of them, as one side run through at constant speed.
struct EdgeChain {
  BoundarySide side;
  /// Where the edges run on it. Constant speed is not the edges' own: cut short enough to be taken
  /// for affine.
  std::vector<Stretch> stretches;
};

/// Joins the stretches [from, to] of edges of a loop, given in its order. Ends that differ by a CAD
/// tolerance are moved to the middle, the rest of their edges with them.
[[nodiscard]] EdgeChain chainEdges(const BoundaryLoop& loop, const std::vector<Stretch>& edges);

}  // namespace fairing::boundary
