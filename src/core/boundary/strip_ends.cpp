// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/strip_ends.h"

#include <algorithm>

namespace fairing::boundary {
namespace {

// Neighbours that turn by more, or whose faces do (degrees), are no single edge of a patch.
constexpr double kSmooth = 1.0;

// An end is one edge of a patch.
std::optional<Error> endTurns(const BoundarySide& before, const Corner& corner) {
  const double turn = std::max(180.0 - corner.angle, corner.normalMismatch);
  if (turn <= kSmooth) return std::nullopt;
  return Error{ErrorCode::EndTurns, before.edge, 0, corner.point, turn};
}

std::optional<Error> endAlongSide(const BoundarySide& side, const Corner& corner) {
  if (corner.angle <= kWidestCorner) return std::nullopt;
  return Error{ErrorCode::EndAlongSide, side.edge, 0, corner.point, corner.angle};
}

std::vector<BoundarySide> between(const ChainPair& pair, std::size_t first, std::size_t end) {
  const auto begin = pair.sides.sides.begin();
  return {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end)};
}

std::vector<BoundarySide> allSides(const ChainPair& pair, const StripEnds& ends) {
  std::vector<BoundarySide> sides;
  for (const auto& part : {between(pair, 0, pair.firstCount),
                           ends[0],
                           between(pair, pair.secondStart(), pair.secondEnd()),
                           ends[1]})
    sides.insert(sides.end(), part.begin(), part.end());
  return sides;
}

// The corner at the end of a side, its gap and what an end may not do there checked.
Result<Corner> cornerAfter(const ChainPair& pair, std::size_t k) {
  const BoundaryLoop& loop = pair.sides;
  const BoundarySide &before = loop.sides[k], &after = loop.sides[loop.next(k)];
  const bool endBefore = pair.isEnd(k), endAfter = pair.isEnd(loop.next(k));
  const Corner corner =
      endBefore || endAfter ? cornerBetween(before, after) : chainCorner(before, after);
  auto wrong = checkMeeting(before, corner, loop.diagonal);
  if (!wrong && endBefore && endAfter) wrong = endTurns(before, corner);
  if (!wrong && endBefore != endAfter) wrong = endAlongSide(endBefore ? after : before, corner);
  if (wrong) return fail(*wrong);
  return corner;
}

}  // namespace

StripEnds endsOf(const ChainPair& pair) {
  return {between(pair, pair.firstCount, pair.secondStart()),
          between(pair, pair.secondEnd(), pair.sides.sides.size())};
}

Result<ChainPair> withEnds(const ChainPair& pair, const StripEnds& ends) {
  ChainPair joined = pair;
  joined.endCounts = {ends[0].size(), ends[1].size()};
  auto loop = measureSides(allSides(pair, ends));
  if (!loop) return fail(loop.error());
  joined.sides = std::move(*loop);
  if (ends[0].empty() && ends[1].empty()) joined.sides.further = {pair.firstCount};
  for (std::size_t k = 0; k < joined.sides.sides.size(); ++k) {
    const bool isLast = k + 1 == joined.firstCount || k + 1 == joined.secondEnd();
    if (isLast && !joined.isJoined(joined.chainOf(k))) {
      joined.sides.corners.push_back({.apart = true});
      continue;
    }
    const auto corner = cornerAfter(joined, k);
    if (!corner) return fail(corner.error());
    joined.sides.corners.push_back(*corner);
  }
  return joined;
}

}  // namespace fairing::boundary
