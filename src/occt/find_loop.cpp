// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/find_loop.h"

#include <algorithm>
#include <map>
#include <set>

#include "occt/loop_walk.h"

namespace fairing::occt {
namespace {

using Eigen::Vector3d;
using Loop = std::vector<LoopEdge>;

/// An outer border spans at least this share of its sheet's bounding box ...
constexpr double kAsLargeAsSheet = 0.9;
/// ... and every other loop of the sheet at most this share of the border's.
constexpr double kClearlySmaller = 0.98;

const BorderEdge& edgeOf(const BorderGraph& graph, const LoopEdge& e) {
  return graph.edges()[std::size_t(e.border)];
}

std::optional<Error> wrongNumber(const ShapeIndex& index, const Picks& picks) {
  std::set<int> seen;
  for (int edge : picks.edges) {
    if (!index.hasEdge(edge)) {
      return Error{
          .code = ErrorCode::EdgeOutOfRange, .edge = edge, .value = double(index.edgeCount())};
    }
    if (!seen.insert(edge).second) return Error{.code = ErrorCode::EdgePickedTwice, .edge = edge};
  }
  for (int face : picks.faces) {
    if (!index.hasFace(face)) {
      return Error{
          .code = ErrorCode::FaceOutOfRange, .face = face, .value = double(index.faceCount())};
    }
  }
  return std::nullopt;
}

/// The picked edges as positions in the graph; with faces alone, their whole border.
Result<std::set<int>> startingPoints(const ShapeIndex& index,
                                     const BorderGraph& graph,
                                     const Picks& picks) {
  if (const auto error = wrongNumber(index, picks)) return fail(*error);
  std::set<int> result;
  std::vector<int> edges = picks.edges;
  std::sort(edges.begin(), edges.end());
  for (int edge : edges) {
    if (graph.find(edge) < 0) return fail(graph.refusal(edge));
    result.insert(graph.find(edge));
  }
  if (picks.edges.empty() && !picks.faces.empty()) {
    for (int edge = 1; edge <= index.edgeCount(); ++edge) {
      const ErrorCode why = graph.find(edge) < 0 ? graph.refusal(edge).code : ErrorCode::Foreign;
      const auto& uses = index.uses(edge);
      const bool ofPicked = std::any_of(uses.begin(), uses.end(), [&](const EdgeUse& use) {
        return std::find(picks.faces.begin(), picks.faces.end(), use.face) != picks.faces.end();
      });
      if (ofPicked && why == ErrorCode::EdgeWithManyFaces) return fail(graph.refusal(edge));
    }
    for (std::size_t i = 0; i < graph.edges().size(); ++i) result.insert(int(i));
  }
  if (result.empty()) return fail({.code = ErrorCode::NothingPicked});
  return result;
}

/// The chain of a set in which every node has two of its edges: follows it from the lowest edge.
Loop chain(const BorderGraph& graph, std::set<int>& left) {
  Loop loop{{*left.begin(), Direction::Forward}};
  left.erase(left.begin());
  while (true) {
    const int node = edgeOf(graph, loop.back()).to(loop.back().direction);
    const auto& there = graph.at(node);
    const auto next =
        std::find_if(there.begin(), there.end(), [&](int i) { return left.contains(i); });
    if (next == there.end()) return loop;
    const bool forward = graph.edges()[std::size_t(*next)].from(Direction::Forward) == node;
    loop.push_back({*next, forward ? Direction::Forward : Direction::Backward});
    left.erase(*next);
  }
}

bool closesByItself(const BorderGraph& graph, const std::set<int>& edges) {
  std::map<int, int> degree;
  for (int i : edges) {
    for (int node : graph.edges()[std::size_t(i)].nodes) ++degree[node];
  }
  return std::all_of(
      degree.begin(), degree.end(), [](const auto& entry) { return entry.second == 2; });
}

/// Runs with the hole to the left for most of the length that has a say, and starts at the lowest
/// edge number.
Loop canonical(const BorderGraph& graph, Loop loop) {
  double agreement = 0.0;
  for (const LoopEdge& e : loop) {
    const BorderEdge& edge = edgeOf(graph, e);
    if (edge.heading) agreement += *edge.heading == e.direction ? edge.length : -edge.length;
  }
  const auto lowest = [&] {
    return std::min_element(loop.begin(), loop.end(), [&](const LoopEdge& a, const LoopEdge& b) {
      return edgeOf(graph, a).edge < edgeOf(graph, b).edge;
    });
  };
  const bool undecided = agreement == 0.0;
  if (agreement < 0.0 || (undecided && lowest()->direction == Direction::Backward)) {
    std::reverse(loop.begin(), loop.end());
    for (LoopEdge& e : loop) {
      e.direction = e.direction == Direction::Forward ? Direction::Backward : Direction::Forward;
    }
  }
  std::rotate(loop.begin(), lowest(), loop.end());
  return loop;
}

/// The picks do not lie on one loop: tells the first one off the loop and how many loops there are.
Error severalLoops(const BorderGraph& graph, const LoopWalk& walk, std::set<int> left) {
  Error error{.code = ErrorCode::SeveralLoops,
              .edge = graph.edges()[std::size_t(*left.begin())].edge,
              .value = 1.0};
  while (!left.empty()) {
    error.value += 1.0;
    const int start = *left.begin();
    left.erase(start);
    if (const auto other = walk.from(start)) {
      for (const LoopEdge& e : *other) left.erase(e.border);
    }
  }
  return error;
}

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

/// For every face the number of its sheet: faces that share edges are one sheet.
std::vector<int> sheets(const ShapeIndex& index) {
  std::vector<int> sheet(std::size_t(index.faceCount()) + 1, 0);
  for (std::size_t i = 0; i < sheet.size(); ++i) sheet[i] = int(i);
  const auto root = [&](int face) {
    while (sheet[std::size_t(face)] != face) face = sheet[std::size_t(face)];
    return face;
  };
  for (int edge = 1; edge <= index.edgeCount(); ++edge) {
    for (const EdgeUse& use : index.uses(edge)) {
      const int a = root(index.uses(edge).front().face);
      const int b = root(use.face);
      sheet[std::size_t(std::max(a, b))] = std::min(a, b);
    }
  }
  for (std::size_t i = 0; i < sheet.size(); ++i) sheet[i] = root(int(i));
  return sheet;
}

void markOuterBorders(const ShapeIndex& index, std::vector<Hole>& holes) {
  const std::vector<int> sheet = sheets(index);
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
    if (members.size() < 2) continue;
    std::vector<std::pair<double, std::size_t>> sizes;
    for (std::size_t i : members) sizes.emplace_back(diagonalOf(index, holes[i].edges).norm(), i);
    std::sort(sizes.rbegin(), sizes.rend());
    const double whole = diagonalOf(index, edgesOf[number]).norm();
    holes[sizes[0].second].isOuterBorder = sizes[0].first >= kAsLargeAsSheet * whole &&
                                           sizes[1].first <= kClearlySmaller * sizes[0].first;
  }
}

}  // namespace

Result<Loop> traceLoop(const ShapeIndex& index, const BorderGraph& graph, const Picks& picks) {
  auto starts = startingPoints(index, graph, picks);
  if (!starts) return fail(starts.error());
  const LoopWalk walk(index, graph, *starts);
  std::set<int> left = *starts;
  Loop loop;
  if (closesByItself(graph, left)) {
    loop = chain(graph, left);
  } else {
    const auto heads = [&](int i) { return graph.edges()[std::size_t(i)].heading.has_value(); };
    const auto clear = std::find_if(left.begin(), left.end(), heads);
    auto found = walk.from(clear != left.end() ? *clear : *left.begin());
    if (!found) return fail(found.error());
    loop = std::move(*found);
    for (const LoopEdge& e : loop) left.erase(e.border);
  }
  if (!left.empty()) return fail(severalLoops(graph, walk, left));
  return canonical(graph, std::move(loop));
}

Result<std::vector<int>> findLoop(const ShapeIndex& index, const Picks& picks) {
  const BorderGraph graph = BorderGraph::build(index, picks);
  const auto loop = traceLoop(index, graph, picks);
  if (!loop) return fail(loop.error());
  std::vector<int> numbers;
  for (const LoopEdge& e : *loop) numbers.push_back(edgeOf(graph, e).edge);
  return numbers;
}

std::vector<Hole> findHoles(const ShapeIndex& index) {
  const BorderGraph graph = BorderGraph::build(index, {});
  const LoopWalk walk(index, graph, {});
  std::set<int> done;
  std::vector<Hole> holes;
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    if (done.contains(int(i)) || !graph.edges()[i].support) continue;
    auto found = walk.from(int(i));
    if (!found) continue;
    Hole hole;
    for (const LoopEdge& e : canonical(graph, std::move(*found))) {
      done.insert(e.border);
      hole.edges.push_back(edgeOf(graph, e).edge);
    }
    holes.push_back(std::move(hole));
  }
  markOuterBorders(index, holes);
  return holes;
}

}  // namespace fairing::occt
