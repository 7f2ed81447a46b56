// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <vector>

#include "core/boundary/cut_loop.h"
#include "core/boundary/side_chain.h"

namespace fairing::boundary {

/// Whether the second chain runs along the first rather than against it: a strip between their
/// starts and their ends would be less twisted than one from start to end.
[[nodiscard]] bool runsAlong(const SideChain& first, const SideChain& second);

/// Where two closed chains of a pair start so that the strip between them is not twisted: the sum
/// of the squared distances of points that belong together, by arc length, is least. The strip's
/// own seam lies where the two are nearest to each other; where they are equally far all round, at
/// the first chain's start.
struct StripStarts {
  LoopPlace first, second;
};
[[nodiscard]] StripStarts matchClosed(const ChainPair& pair);

/// The pair as two sides that run against each other: a chain each, at constant speed where it is
/// made of several edges, is closed, or has more than `mostPoles` control points.
[[nodiscard]] Result<CutLoop> cutPair(const ChainPair& pair, int mostPoles);

}  // namespace fairing::boundary
