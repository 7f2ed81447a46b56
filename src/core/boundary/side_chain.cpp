// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/side_chain.h"

#include <algorithm>

#include "core/boundary/strip_match.h"

namespace fairing::boundary {
namespace {

// Neighbours that meet at a smaller angle (degrees; 180 = straight on) make a corner.
constexpr double kStraightOn = 175.0;
// Faces whose normals differ by more (degrees) meet in an edge. Closer ones count as one, as in
// constraint/tangent_plane.cpp.
constexpr double kSeparateNormals = 5.7;

bool isCrease(const BoundarySide& before, const BoundarySide& after, const Corner& corner) {
  if (before.isTangent() && after.isTangent()) return !corner.normalsAgree(kSeparateNormals);
  return !corner.isNearlyStraight();
}

// With the support normals the other way.
Ribbon turned(Ribbon ribbon) {
  if (ribbon.hasSupport())
    ribbon.support = [support = ribbon.support](double t) {
      SupportSample sample = support(t);
      sample.normal = -sample.normal;
      sample.secondForm = -sample.secondForm;
      return sample;
    };
  return ribbon;
}

std::optional<Error> addCorners(const SideChain& chain, BoundaryLoop& loop) {
  const std::size_t n = chain.sides.size();
  for (std::size_t k = 0; k < n; ++k) {
    const bool isEnd = k + 1 == n;
    Corner corner;
    if (!isEnd || chain.closed) {
      corner = chainCorner(chain.sides[k], chain.sides[(k + 1) % n]);
      if (const auto open = checkMeeting(chain.sides[k], corner, loop.diagonal)) return open;
    }
    corner.apart = isEnd && !chain.closed;
    loop.corners.push_back(corner);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Error> chainTurns(const BoundarySide& before, const Corner& corner) {
  if (corner.angle >= kStraightOn) return std::nullopt;
  return Error{ErrorCode::ChainTurns, before.edge, 0, corner.point, 180.0 - corner.angle};
}

Corner chainCorner(const BoundarySide& before, const BoundarySide& after) {
  Corner corner = cornerBetween(before, after);
  corner.crease = isCrease(before, after, corner);
  corner.changes = before.continuity != after.continuity || before.isTangent() != after.isTangent();
  if (corner.crease) corner.twistMismatch = 0.0;  // the sides lie on different patches
  return corner;
}

bool isCut(const Corner& corner) {
  return !corner.apart && (corner.crease || corner.changes || !corner.isNearlyStraight());
}

SideChain reversed(const SideChain& chain) {
  SideChain result = chain;
  std::reverse(result.sides.begin(), result.sides.end());
  for (BoundarySide& side : result.sides) {
    side.ribbon = turned(reversed(side.ribbon));
    std::reverse(side.stretches.begin(), side.stretches.end());
    for (std::size_t k = 0; k < side.stretches.size(); ++k)
      side.stretches[k].t = k + 1 < side.stretches.size() ? 1.0 - side.stretches[k + 1].t : 1.0;
  }
  return result;
}

Result<ChainPair> pairChains(const SideChain& first, const SideChain& second) {
  if (first.closed != second.closed) {
    const SideChain& open = first.closed ? second : first;
    return fail({.code = ErrorCode::ChainsUnlike, .edge = open.sides.front().edge});
  }
  ChainPair pair;
  pair.closed = first.closed;
  pair.firstCount = first.sides.size();
  const SideChain other = runsAlong(first, second) ? reversed(second) : second;
  std::vector<BoundarySide> sides = first.sides;
  sides.insert(sides.end(), other.sides.begin(), other.sides.end());
  auto loop = measureSides(std::move(sides));
  if (!loop) return fail(loop.error());
  for (const SideChain* chain : {&first, &other})
    if (const auto wrong = addCorners(*chain, *loop)) return fail(*wrong);
  loop->further = {pair.firstCount};
  pair.sides = std::move(*loop);
  return pair;
}

}  // namespace fairing::boundary
