// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/strip.h"

#include <array>

#include "core/boundary/cut_pair.h"

namespace fairing::layout {
namespace {

using boundary::BoundaryLoop;
using Eigen::Vector3d;

constexpr int kSamples = 32;

// Mean distance of the points that belong together, on the patch between two sides.
double meanHeight(const boundary::BoundarySide& south, const boundary::BoundarySide& north) {
  double sum = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const double t = (k + 0.5) / kSamples;
    sum += (south.ribbon.curve(t).point - north.ribbon.curve(1.0 - t).point).norm();
  }
  return sum / kSamples;
}

Vector3d startOf(const BoundaryLoop& loop, int side) {
  return loop.sides[static_cast<std::size_t>(side)].ribbon.curve(0.0).point;
}

// Where the sides of n patches stand in the loop; `ends` are those of its ends, -1 = free.
struct Row {
  int n, second;
  std::array<int, 2> ends;
  bool closed;
};

Row rowOf(const boundary::ChainPair& pair, int n, bool closed) {
  const int second = pair.isJoined(0) ? n + 1 : n;
  return {n, second, {pair.isJoined(0) ? n : -1, pair.isJoined(1) ? second + n : -1}, closed};
}

// Vertex j is the start of side j; free ends of open chains follow.
QuadMesh rowOfQuads(const Row& row, int sideCount) {
  QuadMesh mesh;
  const auto [n, second, ends, closed] = row;
  int vertices = sideCount;
  const auto endOf = [&](int chain, int next) {
    const int end = ends[static_cast<std::size_t>(chain)];
    return closed ? next : end >= 0 ? end : vertices++;
  };
  const int firstEnd = endOf(0, 0), secondEnd = endOf(1, second);
  for (int k = 0; k < n; ++k) {
    const int south = k, north = second + n - 1 - k;
    mesh.quads.push_back(
        {{south, k + 1 < n ? south + 1 : firstEnd, north, k > 0 ? north + 1 : secondEnd},
         {south, k + 1 < n ? -1 : ends[0], north, k > 0 ? -1 : ends[1]}});
  }
  mesh.vertices.assign(static_cast<std::size_t>(vertices), Eigen::Vector2d::Zero());
  mesh.inside.assign(mesh.vertices.size(), 0);
  return mesh;
}

// The picture of a row of quads: seams as long as the way between their ends.
void drawRow(const BoundaryLoop& loop, bool closed, QuadMesh& mesh) {
  const int n = static_cast<int>(mesh.quads.size());
  double width = 0.0;
  for (const Quad& quad : mesh.quads) {
    const auto south = static_cast<std::size_t>(quad.sides[0]);
    const auto north = static_cast<std::size_t>(quad.sides[2]);
    const auto at = [&](int corner) -> Eigen::Vector2d& {
      return mesh
          .vertices[static_cast<std::size_t>(quad.vertices[static_cast<std::size_t>(corner)])];
    };
    const Vector3d end = loop.sides[north].ribbon.curve(1.0).point;
    const double height = n == 1 ? meanHeight(loop.sides[south], loop.sides[north])
                                 : (startOf(loop, quad.sides[0]) - end).norm();
    at(0) = {width, 0.0};
    at(3) = {width, height};
    width += 0.5 * (loop.sides[south].length + loop.sides[north].length);
    if (closed) continue;
    const Vector3d last = loop.sides[south].ribbon.curve(1.0).point;
    at(1) = {width, 0.0};
    at(2) = {width, n == 1 ? height : (last - startOf(loop, quad.sides[2])).norm()};
  }
}

}  // namespace

bool followsAtEnds(const QuadMesh& strip) {
  return strip.quads.back().sides[1] >= 0 || strip.quads.front().sides[3] >= 0;
}

Result<LayoutPlan> stripPlan(const boundary::ChainPair& pair) {
  const auto cuts = boundary::matchChains(pair);
  if (!cuts) return fail(cuts.error());
  auto cut = boundary::cutPair(pair, *cuts, kMostPolesOfOne);
  if (!cut) return fail(cut.error());
  const int n = static_cast<int>(pair.closed ? cuts->size() : cuts->size() - 1);
  const bool isWhole = pair.closed && n == 1;
  LayoutPlan plan{LayoutKind::Strip, std::move(*cut), {}, isWhole};
  const bool isRing = pair.closed && !isWhole;
  plan.mesh = rowOfQuads(rowOf(pair, n, isRing), static_cast<int>(plan.cut.loop.sides.size()));
  drawRow(plan.cut.loop, isRing, plan.mesh);
  for (const boundary::StripCut& c : *cuts)
    plan.matches.push_back({pointAt(pair.sides, c.first), pointAt(pair.sides, c.second)});
  return plan;
}

}  // namespace fairing::layout
