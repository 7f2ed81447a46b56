// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/vertex_blend.h"

#include <optional>

#include "core/layout/loop_corners.h"
#include "core/layout/ring_star.h"

namespace fairing::layout {
namespace {

using boundary::BoundaryLoop;
using boundary::LoopPlace;
using Eigen::Vector3d;

// Where the spoke ends on the stretch of a chain between two corners (starts of sides).
std::optional<LoopPlace> spokeBetween(const LoopLength& lengths,
                                      const std::vector<CornerRole>& roles,
                                      std::size_t from,
                                      std::size_t to) {
  std::vector<std::size_t> splits;
  for (std::size_t k = from + 1; k < to; ++k)
    if (roles[k - 1] == CornerRole::Split) splits.push_back(k);
  return spokeEnd(lengths, splits, 0.5 * (lengths.upTo(from) + lengths.upTo(to)));
}

// Of every chain: its start, a spoke's end, a corner, a spoke's end, ..., its end.
Result<std::vector<LoopPlace>> cutsOf(const BoundaryLoop& loop) {
  const auto roles = cornerRoles(loop);
  std::vector<LoopPlace> cuts;
  for (const auto& [first, end] : loop.chains()) {
    const LoopLength lengths(loop, first, end);
    std::size_t from = first;
    for (std::size_t k = first + 1; k <= end; ++k) {
      if (k < end && roles[k - 1] != CornerRole::Corner) continue;
      const auto spoke = spokeBetween(lengths, roles, from, k);
      if (!spoke) return fail({.code = ErrorCode::LayoutUnfit, .detail = "junction"});
      cuts.push_back({from, 0.0});
      cuts.push_back(*spoke);
      from = k;
    }
    cuts.push_back({end - 1, 1.0});
  }
  return cuts;
}

// Vertices: the starts of all sides; of every chain its end and the middle of the gap after it; the
// centre.
QuadMesh meshOf(const BoundaryLoop& loop) {
  const auto chains = loop.chains();
  const int sides = static_cast<int>(loop.sides.size()), n = static_cast<int>(chains.size());
  const auto endOf = [&](int chain) { return sides + chain; };
  const auto middleAfter = [&](int chain) { return sides + n + (chain + n) % n; };
  const int centre = sides + 2 * n;
  std::vector<Vector3d> points;
  for (const boundary::BoundarySide& side : loop.sides)
    points.push_back(side.ribbon.curve(0.0).point);
  for (const auto& [first, end] : chains)
    points.push_back(loop.sides[end - 1].ribbon.curve(1.0).point);
  for (std::size_t i = 0; i < chains.size(); ++i)
    points.push_back(middleOfWay(
        loop.sides[chains[i].second - 1], 1.0, loop.sides[chains[(i + 1) % chains.size()].first]));
  StarBorder border;
  for (int i = 0; i < n; ++i) {
    const auto& [first, end] = chains[static_cast<std::size_t>(i)];
    border.add(middleAfter(i - 1));
    for (int k = static_cast<int>(first); k < static_cast<int>(end); ++k) border.add(k, k);
    border.add(endOf(i));
  }
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = 0; k < border.vertices.size(); k += 2)
    sum += points[static_cast<std::size_t>(border.vertices[k])];
  points.push_back(sum / (0.5 * static_cast<double>(border.vertices.size())));
  RingMesh mesh(std::move(points), sides + n);
  mesh.addStar(border, centre);
  for (int i = 0; i < n; ++i)
    mesh.showCrossing(middleAfter(i),
                      endOf(i),
                      static_cast<int>(chains[static_cast<std::size_t>((i + 1) % n)].first),
                      {centre});
  return mesh.take();
}

}  // namespace

Result<LayoutPlan> vertexBlendPlan(const BoundaryLoop& loop) {
  const auto cuts = cutsOf(loop);
  if (!cuts) return fail(cuts.error());
  auto cut = boundary::cutLoop(loop, *cuts, kMostPolesOfSeveral);
  if (!cut) return fail(cut.error());
  QuadMesh mesh = meshOf(cut->loop);
  return LayoutPlan{LayoutKind::Junction, std::move(*cut), std::move(mesh)};
}

}  // namespace fairing::layout
