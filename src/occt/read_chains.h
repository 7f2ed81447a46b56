// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <map>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/boundary/chain_ring.h"
#include "core/boundary/side_chain.h"
#include "occt/picks.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// What is to be joined, in any order. Numbers are FreeCAD's (EdgeN).
struct BlendPicks {
  std::vector<int> from = {}, to = {};  ///< one edge of a smooth chain is enough
  /// Of every edge with a face beside it; an edge without one is met G0.
  Continuity continuity = Continuity::G1;
  std::map<int, Continuity> edgeContinuity = {};  ///< by edge number, goes before `continuity`
  /// How far into the faces the blend starts, from the first side and from the second, mm, 0 or
  /// more. readChains() gives the edges themselves: see setback.h.
  std::array<double, 2> setback = {};
  /// Edges that make the curve in the faces where a side starts instead, in any order.
  std::array<std::vector<int>, 2> setbackCurve = {};
  boundary::MatchKind match = boundary::MatchKind::Auto;
  double alignment = 0.0;                       ///< of closed sides (boundary/chain_match.h)
  std::vector<std::pair<int, int>> pairs = {};  ///< VertexN of the sides that belong together
  /// Open chains of the second side are one side each of a blend round a vertex.
  bool ring = false;
  std::vector<int> cuts = {};  ///< edges whose ends are those of the cuts of a junction
  /// Edges, and faces by FaceN, that the ends of a strip between open sides follow (read_ends.h).
  std::vector<int> ends = {}, endFaces = {};

  [[nodiscard]] bool hasEnds() const { return !ends.empty() || !endFaces.empty(); }
  [[nodiscard]] bool isSetBack(std::size_t side) const {
    return setback[side] != 0.0 || !setbackCurve[side].empty();
  }
  [[nodiscard]] bool isSetBack() const { return isSetBack(0) || isSetBack(1); }
};

/// What is wished of the edges, as picks of a hole.
[[nodiscard]] Picks wishesOf(const BlendPicks& picks);

/// The two chains the picks mean: the picked edges of a side, and those that continue them smoothly
/// as long as just one does and no picked one of the other side or of an end is reached; their ends
/// are free: readEnds() adds what they are to follow. Fails with OneSideOnly,
/// EdgeOnBothSides, ChainBroken, ChainBranches, EdgeNotInLoop, VertexOutOfRange, PairOffChain, the
/// refusals of BorderGraph, and the codes of pairChains(). The sides must not be evaluated by two
/// threads at once.
[[nodiscard]] Result<boundary::ChainPair> readChains(const ShapeIndex& index,
                                                     const BlendPicks& picks);

/// What a blend joins: two chains, or three and more in a ring.
using BlendSides = std::variant<boundary::ChainPair, boundary::ChainRing>;

/// What the picks mean: a ring where the edges of the second side make several chains, all of them
/// closed, or all open and `ring` asked for, each extended as readChains() does; else two chains.
/// Fails with CutOffRims, the codes of readChains(), boundary::ringOfLoops() and ringOfChains().
[[nodiscard]] Result<BlendSides> readBlend(const ShapeIndex& index, const BlendPicks& picks);

/// One side of a blend.
struct WholeChain {
  std::vector<int> edges;  ///< in the order they are run through
  bool closed = false;
};

/// The edges `picks.from`, and those readChains() would add when `picks.to` are the picks of the
/// other side. Fails as it does.
[[nodiscard]] Result<WholeChain> wholeChain(const ShapeIndex& index, const BlendPicks& picks);

/// Edges grouped into chains that connect, each ascending, by their lowest edges.
[[nodiscard]] Result<std::vector<std::vector<int>>> groupEdges(const ShapeIndex& index,
                                                               const std::vector<int>& edges);

}  // namespace fairing::occt
