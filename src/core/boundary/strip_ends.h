// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "core/base/result.h"
#include "core/boundary/side_chain.h"

namespace fairing::boundary {

/// Sides at the ends of a strip, head to tail: entry 0 leads from the end of the first chain to the
/// start of the second one, entry 1 from the end of that back to the start of the first. Empty = a
/// free end.
using StripEnds = std::array<std::vector<BoundarySide>, 2>;

[[nodiscard]] StripEnds endsOf(const ChainPair& pair);

/// The pair of open chains with sides at its ends, in place of those it has. Fails with EndTurns
/// where an end has a corner inside, EndAlongSide where it makes none with a side, and the codes of
/// measureSides() and checkMeeting().
[[nodiscard]] Result<ChainPair> withEnds(const ChainPair& pair, const StripEnds& ends);

}  // namespace fairing::boundary
