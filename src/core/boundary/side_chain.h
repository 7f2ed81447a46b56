// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "core/base/result.h"
#include "core/boundary/boundary_loop.h"
#include "core/boundary/chain_match.h"

namespace fairing::boundary {

/// Sides one after the other: the end of side i is the start of side i + 1, and of a closed chain
/// the last one's end is the start of side 0. Seen against the support normals what is to be
/// spanned lies to the left.
struct SideChain {
  std::vector<BoundarySide> sides;
  bool closed = false;
};

/// ChainTurns where the edges of a chain meet in a corner.
[[nodiscard]] std::optional<Error> chainTurns(const BoundarySide& before, const Corner& corner);

/// The chain run through the other way, with the support normals turned, so that what is to be
/// spanned stays to the left.
[[nodiscard]] SideChain reversed(const SideChain& chain);

/// Two chains that a strip is to join.
struct ChainPair {
  /// The sides of the first chain, then those of the second one, which runs against it, as two
  /// chains of a loop; at the ends of open ones the corners are `apart`. With ends (strip_ends.h)
  /// they are one chain round: first, its end, second, its end.
  BoundaryLoop sides;
  std::size_t firstCount = 0;  ///< number of sides of the first chain
  bool closed = false;         ///< both chains are
  ChainMatch match = {};       ///< which points belong together
  /// Numbers of the sides that lead from the end of the first chain to the second one, and back
  /// from the end of that; 0 = a free end.
  std::array<std::size_t, 2> endCounts = {};

  /// The position of the second chain's first side, and the one behind its last.
  [[nodiscard]] std::size_t secondStart() const { return firstCount + endCounts[0]; }
  [[nodiscard]] std::size_t secondEnd() const { return sides.sides.size() - endCounts[1]; }
  /// The sides of a chain, 0 or 1.
  [[nodiscard]] SideRange chain(std::size_t which) const {
    return which == 0 ? SideRange{0, firstCount} : SideRange{secondStart(), secondEnd()};
  }
  /// Whether the end of a chain, 0 or 1, is joined to the start of the other one by sides.
  [[nodiscard]] bool isJoined(std::size_t chain) const { return endCounts[chain] > 0; }
  /// Whether a side belongs to neither chain.
  [[nodiscard]] bool isEnd(std::size_t side) const {
    return side >= secondEnd() || (side >= firstCount && side < secondStart());
  }
  /// 0 for a side of the first chain, 1 for one of the second; of no end.
  [[nodiscard]] std::size_t chainOf(std::size_t side) const { return side < firstCount ? 0 : 1; }
};

/// The corner of a chain where one side ends and the next one starts, its crease told, and whether
/// continuity changes.
[[nodiscard]] Corner chainCorner(const BoundarySide& before, const BoundarySide& after);

/// Whether a strip needs a seam at a corner of a chain: it turns, its faces do, or another
/// continuity is asked for from there on.
[[nodiscard]] bool isCut(const Corner& corner);

/// Two chains as a strip needs them: the second one is turned round where it would make the strip
/// cross itself. Fails with ChainsUnlike (one is open, one closed) and the codes of measureSides()
/// and checkMeeting().
[[nodiscard]] Result<ChainPair> pairChains(const SideChain& first, const SideChain& second);

}  // namespace fairing::boundary
