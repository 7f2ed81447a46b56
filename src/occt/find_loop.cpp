// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/find_loop.h"

#include <algorithm>
#include <map>
#include <set>

#include "occt/loop_walk.h"

namespace fairing::occt {
namespace {

using Loop = std::vector<LoopEdge>;

const BorderEdge& edgeOf(const BorderGraph& graph, const LoopEdge& e) {
  return graph.edges()[std::size_t(e.border)];
}

std::optional<Error> wrongNumber(const ShapeIndex& index, const Picks& picks) {
  if (const auto wrong = wrongEdge(index, picks.edges)) return wrong;
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
  auto result = positionsOf(graph, picks.edges);
  if (!result) return result;
  if (picks.edges.empty() && !picks.faces.empty()) {
    for (int edge = 1; edge <= index.edgeCount(); ++edge) {
      const ErrorCode why = graph.find(edge) < 0 ? graph.refusal(edge).code : ErrorCode::Foreign;
      const auto& uses = index.uses(edge);
      const bool ofPicked = std::any_of(uses.begin(), uses.end(), [&](const EdgeUse& use) {
        return std::find(picks.faces.begin(), picks.faces.end(), use.face) != picks.faces.end();
      });
      if (ofPicked && why == ErrorCode::EdgeWithManyFaces) return fail(graph.refusal(edge));
    }
    for (std::size_t i = 0; i < graph.edges().size(); ++i) result->insert(int(i));
  }
  if (result->empty()) return fail({.code = ErrorCode::NothingPicked});
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

}  // namespace

Loop canonical(const BorderGraph& graph, Loop loop) {
  const double agreement = headingBalance(graph, loop);
  const auto lowest = [&] {
    return std::min_element(loop.begin(), loop.end(), [&](const LoopEdge& a, const LoopEdge& b) {
      return edgeOf(graph, a).edge < edgeOf(graph, b).edge;
    });
  };
  const bool undecided = agreement == 0.0;
  if (agreement < 0.0 || (undecided && lowest()->direction == Direction::Backward)) {
    turnRound(loop);
  }
  std::rotate(loop.begin(), lowest(), loop.end());
  return loop;
}

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

}  // namespace fairing::occt
