// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/read_ends.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "core/boundary/strip_ends.h"
#include "occt/face_projector.h"
#include "occt/guarded.h"
#include "occt/read_side.h"

namespace fairing::occt {
namespace {

using boundary::ChainPair;
using Eigen::Vector3d;
using Walk = std::vector<LoopEdge>;

std::set<int> borderOf(const BorderGraph& graph, int face) {
  std::set<int> positions;
  for (std::size_t k = 0; k < graph.edges().size(); ++k)
    if (const auto& support = graph.edges()[k].support; support && support->face == face)
      positions.insert(int(k));
  return positions;
}

/// Puts the ends together, one pick after the other.
class EndFinder {
 public:
  EndFinder(const ShapeIndex& index, const BorderGraph& graph, const ChainPair& pair)
      : index_(index), graph_(graph), pair_(pair) {
    const std::size_t last = pair.firstCount - 1, second = pair.secondStart();
    nodes_ = {{{nodeAt(last, 1.0), nodeAt(second, 0.0)},
               {nodeAt(pair.secondEnd() - 1, 1.0), nodeAt(0, 0.0)}}};
    for (const boundary::BoundarySide& side : pair.sides.sides)
      onSides_.insert(graph.find(side.edge));
  }

  [[nodiscard]] std::optional<Error> addEdges(std::set<int> left) {
    for (const int position : left)
      if (onSides_.contains(position))
        return Error{.code = ErrorCode::EndOnSide, .edge = edge(position).edge};
    for (const std::size_t chain : {0, 1}) {
      walks_[chain] = walk(left, nodes_[chain]);
      for (const LoopEdge& e : walks_[chain]) left.erase(e.border);
    }
    if (left.empty()) return std::nullopt;
    for (const std::size_t chain : {0, 1})
      if (const Walk other = walk(left, nodes_[chain]); !other.empty())
        return twice(chain, edge(other.front().border).edge, 0);
    return joinsNothing(left);
  }

  /// A face is met where it lies at an end that no pick before it speaks of.
  [[nodiscard]] std::optional<Error> addFace(int face) {
    std::set<int> border = borderOf(graph_, face);
    for (const int position : onSides_) border.erase(position);
    bool found = false;
    for (const std::size_t chain : {0, 1}) {
      const Walk way = walk(border, nodes_[chain]);
      if (way.empty()) continue;
      if (isTaken(chain) && !isSame(way, walks_[chain]))
        return twice(chain, edge(way.front().border).edge, face);
      for (const LoopEdge& e : way) border.erase(e.border);
      if (const Walk other = walk(border, nodes_[chain]); !other.empty())
        return twice(chain, edge(other.front().border).edge, face);
      walks_[chain] = way;
      found = true;
    }
    return found ? std::nullopt : addWall(face);
  }

  [[nodiscard]] Result<EndedPair> finish(const Picks& picks) const {
    boundary::StripEnds ends;
    for (const std::size_t chain : {0, 1})
      for (const LoopEdge& e : walks_[chain])
        ends[chain].push_back(readSide(index_, picks, edge(e.border), e.direction));
    auto joined = boundary::withEnds(pair_, ends);
    if (!joined) return fail(joined.error());
    return EndedPair{std::move(*joined), walls_};
  }

 private:
  using Nodes = std::array<int, 2>;

  [[nodiscard]] const BorderEdge& edge(int position) const {
    return graph_.edges()[std::size_t(position)];
  }
  [[nodiscard]] int nodeAt(std::size_t side, double t) const {
    const boundary::BoundarySide& at = pair_.sides.sides[side];
    const Vector3d point = at.ribbon.curve(t).point;
    const auto [a, b] = edge(graph_.find(at.edge)).nodes;
    return (graph_.point(a) - point).norm() <= (graph_.point(b) - point).norm() ? a : b;
  }
  [[nodiscard]] bool isTaken(std::size_t chain) const {
    return !walks_[chain].empty() || walls_[chain] > 0;
  }
  [[nodiscard]] static bool isSame(const Walk& a, const Walk& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
      return x.border == y.border;
    });
  }

  /// The way with the fewest edges from one node to the other along the edges allowed; empty where
  /// there is none.
  [[nodiscard]] Walk walk(const std::set<int>& allowed, const Nodes& ends) const {
    std::map<int, LoopEdge> arrival;
    std::deque<int> pending{ends[0]};
    while (!pending.empty() && !arrival.contains(ends[1])) {
      const int node = pending.front();
      pending.pop_front();
      for (const int position : graph_.at(node)) {
        if (!allowed.contains(position)) continue;
        const auto way = edge(position).nodes[0] == node ? Direction::Forward : Direction::Backward;
        const int next = edge(position).to(way);
        if (next == ends[0] || !arrival.emplace(next, LoopEdge{position, way}).second) continue;
        pending.push_back(next);
      }
    }
    Walk result;
    if (!arrival.contains(ends[1])) return result;
    for (int node = ends[1]; node != ends[0];
         node = edge(result.front().border).from(result.front().direction))
      result.insert(result.begin(), arrival.at(node));
    return result;
  }

  [[nodiscard]] Error twice(std::size_t chain, int number, int face) const {
    return {.code = ErrorCode::EndTwice,
            .edge = number,
            .face = face,
            .where = graph_.point(nodes_[chain][0])};
  }
  /// Of the loose ends of edges that join no ends the one that lies farthest off.
  [[nodiscard]] Error joinsNothing(const std::set<int>& left) const {
    Error error{.code = ErrorCode::EndJoinsNothing, .edge = edge(*left.begin()).edge};
    for (const int position : left)
      for (const int node : edge(position).nodes) {
        const auto& all = graph_.at(node);
        if (std::count_if(all.begin(), all.end(), [&](int p) { return left.contains(p); }) != 1)
          continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Nodes& ends : nodes_)
          for (const int end : ends)
            nearest = std::min(nearest, (graph_.point(end) - graph_.point(node)).norm());
        if (error.where && nearest <= error.value) continue;
        error.edge = edge(position).edge;
        error.value = nearest;
        error.where = graph_.point(node);
      }
    return error;
  }

  [[nodiscard]] std::optional<Error> addWall(int face) {
    const FaceProjector wall(index_.face(face));
    bool found = false;
    Error off{.code = ErrorCode::EndOffFace,
              .face = face,
              .value = std::numeric_limits<double>::infinity()};
    for (const std::size_t chain : {0, 1}) {
      double distance = 0.0;
      Vector3d where = Vector3d::Zero();
      for (const int node : nodes_[chain])
        if (const double own = wall.nearest(graph_.point(node)).distance; own >= distance)
          distance = own, where = graph_.point(node);
      if (distance <= boundary::kLargestCornerGap * pair_.sides.diagonal) {
        if (isTaken(chain)) return twice(chain, 0, face);
        walls_[chain] = face;
        found = true;
      } else if (distance < off.value) {
        off.value = distance;
        off.where = where;
      }
    }
    return found ? std::nullopt : std::optional(off);
  }

  const ShapeIndex& index_;
  const BorderGraph& graph_;
  const ChainPair& pair_;
  std::array<Nodes, 2> nodes_{};
  std::set<int> onSides_;
  std::array<Walk, 2> walks_;
  std::array<int, 2> walls_{};
};

Result<EndedPair> endsOf(const ShapeIndex& index, const BlendPicks& picks, const ChainPair& pair) {
  if (pair.closed) return fail({.code = ErrorCode::EndsUnused, .edge = pair.sides.sides[0].edge});
  const BorderGraph graph = BorderGraph::build(index, {});
  EndFinder finder(index, graph, pair);
  const auto positions = positionsOf(graph, picks.ends);
  if (!positions) return fail(positions.error());
  if (const auto wrong = finder.addEdges(*positions)) return fail(*wrong);
  for (const int face : picks.endFaces)
    if (const auto wrong = finder.addFace(face)) return fail(*wrong);
  const Picks wishes = wishesOf(picks);
  auto ended = finder.finish(wishes);
  if (!ended) return ended;
  if (const auto stray = strayWish(wishes, ended->pair.sides.sides)) return fail(*stray);
  return ended;
}

}  // namespace

Result<std::set<int>> endPositions(const ShapeIndex& index,
                                   const BorderGraph& graph,
                                   const BlendPicks& picks) {
  if (const auto wrong = wrongEdge(index, picks.ends)) return fail(*wrong);
  auto positions = positionsOf(graph, picks.ends);
  if (!positions) return positions;
  for (const int face : picks.endFaces) {
    if (!index.hasFace(face))
      return fail(
          {.code = ErrorCode::FaceOutOfRange, .face = face, .value = double(index.faceCount())});
    positions->merge(borderOf(graph, face));
  }
  return positions;
}

Result<EndedPair> readEnds(const ShapeIndex& index,
                           const BlendPicks& picks,
                           const ChainPair& pair) {
  if (!picks.hasEnds()) return EndedPair{pair};
  return guarded([&] { return endsOf(index, picks, pair); });
}

}  // namespace fairing::occt
