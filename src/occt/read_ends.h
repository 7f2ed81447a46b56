// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <set>

#include "core/base/result.h"
#include "core/boundary/side_chain.h"
#include "occt/border_graph.h"
#include "occt/read_chains.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// Positions of the border edges that the ends of a blend may run along: the picked ones and those
/// of the picked faces. Fails with EdgeOutOfRange, EdgePickedTwice, FaceOutOfRange and the refusals
/// of BorderGraph.
[[nodiscard]] Result<std::set<int>> endPositions(const ShapeIndex& index,
                                                 const BorderGraph& graph,
                                                 const BlendPicks& picks);

/// Two chains, and what the ends of a strip between them are to follow.
struct EndedPair {
  boundary::ChainPair pair;  ///< with the edges that join its ends
  /// FaceN that the end of the first chain's strip slides on, and that of the second's; 0 = none.
  std::array<int, 2> walls = {};
};

/// The pair with the ends that the picks mean: the picked edges where they lead from an end of one
/// chain to that of the other; of a picked face the edges of its border that do, else, where both
/// ends lie on it, the face itself as a wall. Fails with EndsUnused, EndOnSide, EndJoinsNothing,
/// EndTwice, EndOffFace, EdgeNotInLoop and the codes of endPositions() and boundary::withEnds().
[[nodiscard]] Result<EndedPair> readEnds(const ShapeIndex& index,
                                         const BlendPicks& picks,
                                         const boundary::ChainPair& pair);

}  // namespace fairing::occt
