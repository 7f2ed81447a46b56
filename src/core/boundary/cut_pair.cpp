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

void addCorners(const ChainPair& pair, BoundaryLoop& loop) {
  const std::size_t n = loop.sides.size() / 2;
  loop.further = {n};
  for (std::size_t k = 0; k < loop.sides.size(); ++k) {
    Corner corner;
    const bool isEnd = loop.next(k) <= k;
    if (!isEnd || pair.closed) corner = chainCorner(loop.sides[k], loop.sides[loop.next(k)]);
    corner.apart = isEnd && (!pair.closed || n == 1);
    loop.corners.push_back(corner);
  }
}

}  // namespace

Result<CutLoop> cutPair(const ChainPair& pair, const std::vector<StripCut>& cuts, int mostPoles) {
  const std::size_t n = pair.closed ? cuts.size() : cuts.size() - 1;
  std::vector<EdgeChain> chains;
  for (std::size_t k = 0; k < n; ++k)
    chains.push_back(
        sideBetween(pair, cuts[k].first, cuts[(k + 1) % cuts.size()].first, mostPoles));
  for (std::size_t k = n; k-- > 0;)
    chains.push_back(
        sideBetween(pair, cuts[(k + 1) % cuts.size()].second, cuts[k].second, mostPoles));
  CutLoop cut;
  std::vector<BoundarySide> sides;
  for (EdgeChain& chain : chains) {
    sides.push_back(std::move(chain.side));
    cut.stretches.push_back(std::move(chain.stretches));
  }
  auto loop = measureSides(std::move(sides));
  if (!loop) return fail(loop.error());
  loop->diagonal = pair.sides.diagonal;
  addCorners(pair, *loop);
  cut.loop = std::move(*loop);
  return cut;
}

}  // namespace fairing::boundary
