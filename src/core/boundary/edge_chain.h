// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/boundary/cut_loop.h"

namespace fairing::boundary {

/// Edges of a loop, or stretches of them, as one side.
struct EdgeChain {
  BoundarySide side;
  /// Where the edges run on it. Where constant speed is not the edges' own: cut short enough to be
  /// taken for affine.
  std::vector<Stretch> stretches;
};

/// Joins the stretches [from, to] of edges of a loop, given in its order, to a side run through at
/// constant speed. Ends that differ by a CAD
/// tolerance are moved to the middle, the rest of their edges with them.
[[nodiscard]] EdgeChain chainEdges(const BoundaryLoop& loop, const std::vector<Stretch>& edges);

/// The same, but a stretch of one edge keeps its parameter (a polynomial stays one) unless it is a
/// polynomial with more than `mostPoles` control points: such edges come from approximations, their
/// own speed is rough and would cost a patch many knots.
[[nodiscard]] EdgeChain sideOfStretches(const BoundaryLoop& loop,
                                        const std::vector<Stretch>& stretches,
                                        int mostPoles);

}  // namespace fairing::boundary
