// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/read_chains.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "core/boundary/ring_of_chains.h"
#include "core/boundary/ring_of_loops.h"
#include "occt/border_graph.h"
#include "occt/edge_curve.h"
#include "occt/from_occt.h"
#include "occt/guarded.h"
#include "occt/read_ends.h"
#include "occt/read_side.h"

namespace fairing::occt {
namespace {

using boundary::SideChain;

constexpr double kSmooth = 1.0;  // degrees between edges that continue each other

/// One side of a blend while it is put together, edge by edge.
class ChainBuilder {
 public:
  ChainBuilder(const ShapeIndex& index, const BorderGraph& graph, const std::set<int>& picked)
      : index_(index), graph_(graph), left_(picked) {}

  /// All picked edges head to tail; fails with ChainBranches or ChainBroken.
  [[nodiscard]] std::optional<Error> connect() {
    for (const int position : left_)
      for (const int node : border(position).nodes)
        if (const int meeting = countAt(node); meeting > 2)
          return Error{.code = ErrorCode::ChainBranches,
                       .edge = border(position).edge,
                       .where = graph_.point(node)};
    const int first = *left_.begin();
    take({first, Direction::Forward}, true);
    while (const auto next = pickedAfter(chain_.back(), true)) take(*next, true);
    while (const auto next = pickedAfter(chain_.front(), false)) take(*next, false);
    if (left_.empty()) return std::nullopt;
    const BorderEdge& lost = border(*left_.begin());
    return Error{
        .code = ErrorCode::ChainBroken, .edge = lost.edge, .where = graph_.point(lost.nodes[0])};
  }
  /// Goes on along edges that continue the chain smoothly, but for those in `others`.
  void extend(const std::set<int>& others) {
    while (const auto next = smoothAfter(chain_.back(), true, others)) take(*next, true);
    while (const auto next = smoothAfter(chain_.front(), false, others)) take(*next, false);
  }
  [[nodiscard]] bool isClosed() const { return startOf(chain_.front()) == endOf(chain_.back()); }
  [[nodiscard]] SideChain finish(const Picks& picks) {
    if (headingBalance(graph_, chain_) < 0.0) turnRound(chain_);
    SideChain result;
    result.closed = isClosed();
    for (const LoopEdge& e : chain_)
      result.sides.push_back(readSide(index_, picks, border(e.border), e.direction));
    return result;
  }
  [[nodiscard]] std::vector<int> edges() const {
    std::vector<int> all;
    for (const LoopEdge& e : chain_) all.push_back(border(e.border).edge);
    return all;
  }
  [[nodiscard]] std::set<int> positions() const {
    std::set<int> all;
    for (const LoopEdge& e : chain_) all.insert(e.border);
    return all;
  }

 private:
  [[nodiscard]] const BorderEdge& border(int position) const {
    return graph_.edges()[std::size_t(position)];
  }
  [[nodiscard]] int startOf(const LoopEdge& e) const { return border(e.border).from(e.direction); }
  [[nodiscard]] int endOf(const LoopEdge& e) const { return border(e.border).to(e.direction); }
  [[nodiscard]] int countAt(int node) const {
    const auto& all = graph_.at(node);
    return int(std::count_if(all.begin(), all.end(), [&](int p) { return left_.contains(p); }));
  }
  void take(const LoopEdge& e, bool atEnd) {
    left_.erase(e.border);
    chain_.insert(atEnd ? chain_.end() : chain_.begin(), e);
  }
  /// The edge run through so that it goes on from `node` (atEnd), or arrives there.
  [[nodiscard]] LoopEdge directed(int position, int node, bool atEnd) const {
    const int leaves = atEnd ? border(position).nodes[0] : border(position).nodes[1];
    return {position, leaves == node ? Direction::Forward : Direction::Backward};
  }
  [[nodiscard]] std::optional<LoopEdge> pickedAfter(const LoopEdge& last, bool atEnd) const {
    const int node = atEnd ? endOf(last) : startOf(last);
    for (const int position : graph_.at(node))
      if (left_.contains(position)) return directed(position, node, atEnd);
    return std::nullopt;
  }
  [[nodiscard]] Eigen::Vector3d tangent(const LoopEdge& e, double t) const {
    return EdgeCurve(index_.edge(border(e.border).edge), e.direction).at(t).derivative.normalized();
  }
  [[nodiscard]] std::optional<LoopEdge> smoothAfter(const LoopEdge& last,
                                                    bool atEnd,
                                                    const std::set<int>& others) const {
    const int node = atEnd ? endOf(last) : startOf(last);
    const std::set<int> own = positions();
    std::optional<LoopEdge> found;
    for (const int position : graph_.at(node)) {
      if (own.contains(position) || others.contains(position)) continue;
      const LoopEdge next = directed(position, node, atEnd);
      const double cosine = tangent(last, atEnd ? 1.0 : 0.0).dot(tangent(next, atEnd ? 0.0 : 1.0));
      if (!(cosine > std::cos(kSmooth * std::numbers::pi / 180.0))) continue;
      if (found) return std::nullopt;
      found = next;
    }
    return found;
  }
  const ShapeIndex& index_;
  const BorderGraph& graph_;
  std::set<int> left_;
  std::vector<LoopEdge> chain_;
};

Result<std::set<int>> pickedPositions(const ShapeIndex& index,
                                      const BorderGraph& graph,
                                      const std::vector<int>& edges) {
  if (const auto wrong = wrongEdge(index, edges)) return fail(*wrong);
  return positionsOf(graph, edges);
}

std::optional<Error> checkSides(const BlendPicks& picks) {
  if (picks.from.empty() && picks.to.empty()) return Error{.code = ErrorCode::NothingPicked};
  if (picks.from.empty()) return Error{.code = ErrorCode::OneSideOnly, .detail = "from"};
  if (picks.to.empty()) return Error{.code = ErrorCode::OneSideOnly, .detail = "to"};
  for (const int edge : picks.from)
    if (std::find(picks.to.begin(), picks.to.end(), edge) != picks.to.end())
      return Error{.code = ErrorCode::EdgeOnBothSides, .edge = edge};
  return std::nullopt;
}

/// Edges grouped into chains that connect, each ascending, by their lowest edges.
Result<std::vector<std::vector<int>>> groupsOf(const ShapeIndex& index,
                                               const BorderGraph& graph,
                                               const std::vector<int>& edges) {
  auto left = pickedPositions(index, graph, edges);
  if (!left) return fail(left.error());
  std::vector<std::vector<int>> groups;
  while (!left->empty()) {
    std::vector<int> pending{*left->begin()}, group;
    left->erase(left->begin());
    while (!pending.empty()) {
      const BorderEdge& e = graph.edges()[std::size_t(pending.back())];
      pending.pop_back();
      group.push_back(e.edge);
      for (const int node : e.nodes)
        for (const int position : graph.at(node))
          if (left->erase(position) > 0) pending.push_back(position);
    }
    std::sort(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

/// A chain a group of picks; none goes on into another, or into an end.
Result<std::vector<SideChain>> chainsOf(const ShapeIndex& index,
                                        const BorderGraph& graph,
                                        const std::vector<std::vector<int>>& groups,
                                        const BlendPicks& picks) {
  const auto ends = endPositions(index, graph, picks);
  if (!ends) return fail(ends.error());
  std::vector<ChainBuilder> builders;
  for (const std::vector<int>& group : groups) {
    const auto positions = pickedPositions(index, graph, group);
    if (!positions) return fail(positions.error());
    builders.emplace_back(index, graph, *positions);
    if (const auto broken = builders.back().connect()) return fail(*broken);
  }
  std::vector<SideChain> chains;
  for (ChainBuilder& builder : builders) {
    std::set<int> others = *ends;
    for (const ChainBuilder& other : builders)
      if (&other != &builder) others.merge(other.positions());
    builder.extend(others);
    chains.push_back(builder.finish(wishesOf(picks)));
  }
  return chains;
}

/// Finds the joints of both sides that vertices stand for.
class VertexFinder {
 public:
  VertexFinder(const ShapeIndex& index, const boundary::ChainPair& pair) : pair_(pair) {
    TopExp::MapShapes(index.shape(), TopAbs_VERTEX, vertices_);
  }
  /// Two vertices, in any order. Fails with VertexOutOfRange or PairOffChain.
  [[nodiscard]] Result<boundary::JointPair> pairOf(int a, int b) const {
    for (const int vertex : {a, b})
      if (vertex < 1 || vertex > vertices_.Extent())
        return fail({.code = ErrorCode::VertexOutOfRange,
                     .edge = vertex,
                     .value = double(vertices_.Extent())});
    if (!onFirst(a) && onFirst(b)) std::swap(a, b);
    const auto first = onFirst(a), second = onSecond(b);
    for (const auto& [vertex, place] : {std::pair{a, first}, {b, second}})
      if (!place)
        return fail({.code = ErrorCode::PairOffChain, .edge = vertex, .where = pointOf(vertex)});
    return boundary::JointPair{*first, *second, a, b};
  }

 private:
  using Place = std::optional<boundary::LoopPlace>;
  [[nodiscard]] Eigen::Vector3d pointOf(int vertex) const {
    return fromOcct(BRep_Tool::Pnt(TopoDS::Vertex(vertices_(vertex))));
  }
  [[nodiscard]] Place onFirst(int vertex) const { return on(vertex, pair_.chain(0)); }
  [[nodiscard]] Place onSecond(int vertex) const { return on(vertex, pair_.chain(1)); }
  [[nodiscard]] Place on(int vertex, const boundary::SideRange& chain) const {
    const Eigen::Vector3d point = pointOf(vertex);
    double nearest = boundary::kLargestCornerGap * pair_.sides.diagonal;
    Place found;
    for (std::size_t k = chain.first; k < chain.second; ++k)
      for (const double t : {0.0, 1.0}) {
        const double distance = (pair_.sides.sides[k].ribbon.curve(t).point - point).norm();
        if (distance <= nearest) nearest = distance, found = boundary::LoopPlace{k, t};
      }
    return found;
  }
  const boundary::ChainPair& pair_;
  TopTools_IndexedMapOfShape vertices_;
};

Result<boundary::ChainPair> pairOf(const ShapeIndex& index,
                                   const BorderGraph& graph,
                                   const BlendPicks& picks) {
  const auto chains = chainsOf(index, graph, {picks.from, picks.to}, picks);
  if (!chains) return fail(chains.error());
  auto pair = boundary::pairChains(chains->front(), chains->back());
  if (!pair) return pair;
  const auto stray = strayWish(wishesOf(picks), pair->sides.sides);
  if (stray && !picks.hasEnds()) return fail(*stray);
  pair->match = {picks.match, picks.alignment, {}};
  const VertexFinder finder(index, *pair);
  for (const auto& [a, b] : picks.pairs) {
    const auto joint = finder.pairOf(a, b);
    if (!joint) return fail(joint.error());
    pair->match.pairs.push_back(*joint);
  }
  return pair;
}

/// The first side's chain and those of the second one where they make a ring; else nothing.
Result<std::vector<SideChain>> chainsOfRing(const ShapeIndex& index,
                                            const BorderGraph& graph,
                                            const BlendPicks& picks) {
  auto groups = groupsOf(index, graph, picks.to);
  if (!groups || groups->size() < 2) return {};
  groups->insert(groups->begin(), picks.from);
  auto chains = chainsOf(index, graph, *groups, picks);
  if (picks.ring) return chains;
  const auto isClosed = [](const SideChain& chain) { return chain.closed; };
  if (!chains || !std::all_of(chains->begin() + 1, chains->end(), isClosed)) return {};
  return chains;
}

/// The place on the rims where an end of an edge that shows a cut lies.
Result<boundary::LoopPlace> placeOnRims(const boundary::BoundaryLoop& rims,
                                        const Eigen::Vector3d& end,
                                        int edge) {
  const boundary::LoopPlace place = boundary::nearestPlace(rims, end);
  const double distance = (boundary::pointAt(rims, place) - end).norm();
  if (distance > boundary::kLargestCornerGap * rims.diagonal)
    return fail({.code = ErrorCode::CutOffRims, .edge = edge, .where = end, .value = distance});
  return place;
}

Result<std::vector<boundary::RingCut>> cutsOf(const ShapeIndex& index,
                                              const boundary::BoundaryLoop& rims,
                                              const std::vector<int>& edges) {
  if (const auto wrong = wrongEdge(index, edges)) return fail(*wrong);
  std::vector<boundary::RingCut> cuts;
  for (const int edge : edges) {
    const EdgeCurve curve(index.edge(edge), Direction::Forward);
    const auto first = placeOnRims(rims, curve.at(0.0).point, edge);
    if (!first) return fail(first.error());
    const auto second = placeOnRims(rims, curve.at(1.0).point, edge);
    if (!second) return fail(second.error());
    cuts.push_back({*first, *second, edge});
  }
  return cuts;
}

Result<boundary::ChainRing> ringOf(const ShapeIndex& index,
                                   const std::vector<SideChain>& chains,
                                   const BlendPicks& picks) {
  auto loop = picks.ring && !chains.front().closed ? boundary::ringOfChains(chains)
                                                   : boundary::ringOfLoops(chains);
  if (!loop) return fail(loop.error());
  if (const auto stray = strayWish(wishesOf(picks), loop->sides)) return fail(*stray);
  if (loop->isOpen() && !picks.cuts.empty())
    return fail({.code = ErrorCode::CutUnfit, .edge = picks.cuts.front()});
  const auto cuts = cutsOf(index, *loop, picks.cuts);
  if (!cuts) return fail(cuts.error());
  return boundary::ChainRing{std::move(*loop), *cuts};
}

}  // namespace

Picks wishesOf(const BlendPicks& picks) {
  Picks result;
  result.continuity = picks.continuity;
  result.edgeContinuity = picks.edgeContinuity;
  return result;
}

Result<boundary::ChainPair> readChains(const ShapeIndex& index, const BlendPicks& picks) {
  return guarded([&]() -> Result<boundary::ChainPair> {
    if (const auto wrong = checkSides(picks)) return fail(*wrong);
    return pairOf(index, BorderGraph::build(index, {}), picks);
  });
}

Result<BlendSides> readBlend(const ShapeIndex& index, const BlendPicks& picks) {
  return guarded([&]() -> Result<BlendSides> {
    if (const auto wrong = checkSides(picks)) return fail(*wrong);
    const BorderGraph graph = BorderGraph::build(index, {});
    const auto chains = chainsOfRing(index, graph, picks);
    if (!chains) return fail(chains.error());
    if (chains->size() > 2) return ringOf(index, *chains, picks);
    return pairOf(index, graph, picks);
  });
}

Result<WholeChain> wholeChain(const ShapeIndex& index, const BlendPicks& picks) {
  return guarded([&]() -> Result<WholeChain> {
    if (picks.from.empty()) return fail({.code = ErrorCode::NothingPicked});
    const BorderGraph graph = BorderGraph::build(index, {});
    const auto own = pickedPositions(index, graph, picks.from);
    if (!own) return fail(own.error());
    auto foreign = pickedPositions(index, graph, picks.to);
    if (!foreign) return fail(foreign.error());
    auto ends = endPositions(index, graph, picks);
    if (!ends) return fail(ends.error());
    foreign->merge(*ends);
    ChainBuilder chain(index, graph, *own);
    if (const auto broken = chain.connect()) return fail(*broken);
    chain.extend(*foreign);
    return WholeChain{chain.edges(), chain.isClosed()};
  });
}

Result<std::vector<std::vector<int>>> groupEdges(const ShapeIndex& index,
                                                 const std::vector<int>& edges) {
  return guarded([&]() -> Result<std::vector<std::vector<int>>> {
    return groupsOf(index, BorderGraph::build(index, {}), edges);
  });
}

}  // namespace fairing::occt
