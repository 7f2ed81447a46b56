// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/find_holes.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "occt/border_graph.h"
#include "occt/border_turning.h"
#include "occt/find_loop.h"
#include "occt/loop_walk.h"

namespace fairing::occt {
namespace {

using Eigen::Vector3d;

/// An outer border spans at least this share of its sheet's bounding box ...
constexpr double kAsLargeAsSheet = 0.9;
/// ... and every other loop of the sheet at most this share of the border's.
constexpr double kClearlySmaller = 0.98;
/// The only loop of a sheet is its outer border where it turns by less than this (radians); the rim
/// of a flat sheet turns by -2 pi, that of half a sphere by 0.
constexpr double kTurnsRound = -1.5 * std::numbers::pi;

Vector3d diagonalOf(const ShapeIndex& index, const std::vector<int>& edges) {
  Vector3d low = Vector3d::Constant(1e300);
  Vector3d high = -low;
  for (int number : edges) {
    const EdgeCurve curve(index.edge(number), Direction::Forward);
    if (!curve.isFinite()) continue;
    for (int i = 0; i <= 8; ++i) {
      low = low.cwiseMin(curve.point(i / 8.0));
      high = high.cwiseMax(curve.point(i / 8.0));
    }
  }
  return high - low;
}

/// For every face the number of its sheet: faces that share edges, or touch along them, are one
/// sheet.
std::vector<int> sheets(const ShapeIndex& index, const BorderGraph& graph) {
  std::vector<int> sheet(std::size_t(index.faceCount()) + 1, 0);
  std::iota(sheet.begin(), sheet.end(), 0);
  const auto root = [&](int face) {
    while (sheet[std::size_t(face)] != face) face = sheet[std::size_t(face)];
    return face;
  };
  const auto join = [&](int one, int other) {
    const int a = root(one);
    const int b = root(other);
    sheet[std::size_t(std::max(a, b))] = std::min(a, b);
  };
  for (int edge = 1; edge <= index.edgeCount(); ++edge) {
    for (const EdgeUse& use : index.uses(edge)) join(index.uses(edge).front().face, use.face);
  }
  for (const std::vector<int>& seam : graph.looseSeams()) {
    for (int face : seam) join(seam.front(), face);
  }
  for (std::size_t i = 0; i < sheet.size(); ++i) sheet[i] = root(int(i));
  return sheet;
}

/// `loops` are the holes as loops of the graph.
void markOuterBorders(const ShapeIndex& index,
                      const BorderGraph& graph,
                      const std::vector<std::vector<LoopEdge>>& loops,
                      std::vector<Hole>& holes) {
  const std::vector<int> sheet = sheets(index, graph);
  std::map<int, std::vector<int>> edgesOf;
  std::map<int, std::vector<std::size_t>> holesOf;
  for (int edge = 1; edge <= index.edgeCount(); ++edge) {
    if (!index.uses(edge).empty()) {
      edgesOf[sheet[std::size_t(index.uses(edge).front().face)]].push_back(edge);
    }
  }
  for (std::size_t i = 0; i < holes.size(); ++i) {
    for (int edge : holes[i].edges) {
      if (index.uses(edge).empty()) continue;
      holesOf[sheet[std::size_t(index.uses(edge).front().face)]].push_back(i);
      break;
    }
  }
  for (const auto& [number, members] : holesOf) {
    if (members.size() < 2) {
      Hole& only = holes[members.front()];
      only.isOuterBorder = turningAlong(index, graph, loops[members.front()]) < kTurnsRound;
      continue;
    }
    std::vector<std::pair<double, std::size_t>> sizes;
    for (std::size_t i : members) sizes.emplace_back(diagonalOf(index, holes[i].edges).norm(), i);
    std::sort(sizes.rbegin(), sizes.rend());
    const double whole = diagonalOf(index, edgesOf[number]).norm();
    holes[sizes[0].second].isOuterBorder = sizes[0].first >= kAsLargeAsSheet * whole &&
                                           sizes[1].first <= kClearlySmaller * sizes[0].first;
  }
}

}  // namespace

std::vector<Hole> findHoles(const ShapeIndex& index) {
  const BorderGraph graph = BorderGraph::build(index, {});
  const LoopWalk walk(index, graph, {});
  std::set<int> done;
  std::vector<Hole> holes;
  std::vector<std::vector<LoopEdge>> loops;
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    if (done.contains(int(i)) || !graph.edges()[i].support) continue;
    auto found = walk.from(int(i));
    if (!found) continue;
    Hole hole;
    loops.push_back(canonical(graph, std::move(*found)));
    for (const LoopEdge& e : loops.back()) {
      done.insert(e.border);
      hole.edges.push_back(graph.edges()[std::size_t(e.border)].edge);
    }
    holes.push_back(std::move(hole));
  }
  markOuterBorders(index, graph, loops, holes);
  return holes;
}

}  // namespace fairing::occt
