// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/cut_pair.h"

#include "core/boundary/edge_chain.h"

namespace fairing::boundary {
namespace {

// Points of chains that close in one patch belong together by arc length.
EdgeChain sideBetween(const ChainPair& pair, LoopPlace from, LoopPlace to, int mostPoles) {
  const std::vector<Stretch> stretches = stretchesBetween(pair.sides, from, to);
  const bool isWhole = from.side == to.side && from.t == to.t;
  return isWhole ? chainEdges(pair.sides, stretches)
                 : sideOfStretches(pair.sides, stretches, mostPoles);
}

// Of n patches: `second` is the position of the second chain's first side.
void addCorners(const ChainPair& pair, std::size_t n, std::size_t second, BoundaryLoop& loop) {
  if (!pair.isJoined(0) && !pair.isJoined(1)) loop.further = {n};
  for (std::size_t k = 0; k < loop.sides.size(); ++k) {
    const bool isOfChain = k < n || (k >= second && k < second + n);
    const bool isLast = k + 1 == n || k + 1 == second + n;
    const bool isFree = isLast && !pair.isJoined(k < n ? 0 : 1);
    const BoundarySide &before = loop.sides[k], &after = loop.sides[loop.next(k)];
    Corner corner;
    if (pair.closed || (isOfChain && !isLast))
      corner = chainCorner(before, after);
    else if (!isFree)
      corner = cornerBetween(before, after);
    corner.apart = isFree && (!pair.closed || n == 1);
    loop.corners.push_back(corner);
  }
}

// The sides of an end as one.
EdgeChain endBetween(const ChainPair& pair, std::size_t first, std::size_t end, int mostPoles) {
  std::vector<Stretch> stretches;
  for (std::size_t k = first; k < end; ++k) stretches.push_back({k});
  return sideOfStretches(pair.sides, stretches, mostPoles);
}

}  // namespace

Result<CutLoop> cutPair(const ChainPair& pair, const std::vector<StripCut>& cuts, int mostPoles) {
  const std::size_t n = pair.closed ? cuts.size() : cuts.size() - 1;
  std::vector<EdgeChain> chains;
  for (std::size_t k = 0; k < n; ++k)
    chains.push_back(
        sideBetween(pair, cuts[k].first, cuts[(k + 1) % cuts.size()].first, mostPoles));
  if (pair.isJoined(0))
    chains.push_back(endBetween(pair, pair.firstCount, pair.secondStart(), mostPoles));
  const std::size_t second = chains.size();
  for (std::size_t k = n; k-- > 0;)
    chains.push_back(
        sideBetween(pair, cuts[(k + 1) % cuts.size()].second, cuts[k].second, mostPoles));
  if (pair.isJoined(1))
    chains.push_back(endBetween(pair, pair.secondEnd(), pair.sides.sides.size(), mostPoles));
  CutLoop cut;
  std::vector<BoundarySide> sides;
  for (EdgeChain& chain : chains) {
    sides.push_back(std::move(chain.side));
    cut.stretches.push_back(std::move(chain.stretches));
  }
  auto loop = measureSides(std::move(sides));
  if (!loop) return fail(loop.error());
  loop->diagonal = pair.sides.diagonal;
  addCorners(pair, n, second, *loop);
  cut.loop = std::move(*loop);
  return cut;
}

}  // namespace fairing::boundary
