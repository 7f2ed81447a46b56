// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/border_graph.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "occt/border_candidates.h"
#include "occt/coincidence.h"

namespace fairing::occt {
namespace {

/// Which of coincident edges speaks for all: a face's edge rather than a lone one, unless only the
/// lone one was picked.
const Candidate& spokesman(const std::vector<const Candidate*>& group,
                           const std::set<int>& pickedEdges) {
  const auto rank = [&](const Candidate* c) {
    return std::tuple(!c->walkable, !pickedEdges.contains(c->edge), c->isLone(), c->edge);
  };
  return **std::min_element(
      group.begin(), group.end(), [&](const Candidate* a, const Candidate* b) {
        return rank(a) < rank(b);
      });
}

std::vector<EdgeUse> stayingFaces(const std::vector<const Candidate*>& group) {
  std::vector<EdgeUse> faces;
  for (const Candidate* c : group) faces.insert(faces.end(), c->staying.begin(), c->staying.end());
  return faces;
}

std::vector<int> numbersOf(const std::vector<EdgeUse>& uses) {
  std::vector<int> faces;
  for (const EdgeUse& use : uses) faces.push_back(use.face);
  return faces;
}

/// The hole lies opposite to the face that stays, or where the removed face was.
std::optional<Direction> headingOf(const Candidate& c) {
  const auto reversed = [](const EdgeUse& use) {
    return use.edge.Orientation() == TopAbs_REVERSED;
  };
  if (!c.staying.empty()) {
    return reversed(c.staying.front()) ? Direction::Forward : Direction::Backward;
  }
  if (c.removed) return reversed(*c.removed) ? Direction::Backward : Direction::Forward;
  return std::nullopt;
}

/// `faces`: what stays beside this edge and its twins, at most one.
BorderEdge borderOf(const Candidate& c, const std::vector<EdgeUse>& faces) {
  BorderEdge border{.edge = c.edge, .nodes = c.ends, .heading = headingOf(c), .length = c.length};
  if (!c.isLone() && !faces.empty()) {
    border.support = faces.front();
    border.match = c.staying.empty() ? EdgeMatch::Twin : EdgeMatch::Same;
  }
  return border;
}

}  // namespace

int BorderGraph::find(int edge) const {
  return position_[std::size_t(edge)];
}

Error BorderGraph::refusal(int edge) const {
  return refusals_[std::size_t(edge)];
}

BorderGraph BorderGraph::build(const ShapeIndex& index, const Picks& picks) {
  const std::set<int> pickedEdges(picks.edges.begin(), picks.edges.end());
  Candidates candidates =
      collectCandidates(index, std::set<int>(picks.faces.begin(), picks.faces.end()));
  BorderGraph graph;
  graph.points_ = joinEnds(index, candidates.edges);
  graph.position_.assign(std::size_t(index.edgeCount()) + 1, -1);
  graph.refusals_ = std::move(candidates.refusals);
  for (const std::vector<int>& positions : groupsOfTwins(index, candidates.edges)) {
    std::vector<const Candidate*> group;
    for (int i : positions) group.push_back(&candidates.edges[std::size_t(i)]);
    const Candidate& chosen = spokesman(group, pickedEdges);
    const std::vector<EdgeUse> faces = stayingFaces(group);
    if (!chosen.walkable) continue;
    for (const Candidate* c : group) {
      const auto slot = std::size_t(c->edge);
      if (faces.size() > 1) {
        graph.refusals_[slot] = notFree(c->edge, faces.size());
      } else {
        graph.position_[slot] = int(graph.edges_.size());
      }
    }
    if (faces.size() <= 1) {
      graph.edges_.push_back(borderOf(chosen, faces));
    } else {
      graph.looseSeams_.push_back(numbersOf(faces));
    }
  }
  graph.connect();
  return graph;
}

void BorderGraph::connect() {
  incident_.resize(points_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    for (int node : edges_[i].nodes) incident_[std::size_t(node)].push_back(int(i));
  }
}

std::optional<Error> wrongEdge(const ShapeIndex& index, const std::vector<int>& edges) {
  std::set<int> seen;
  for (int edge : edges) {
    if (!index.hasEdge(edge)) {
      return Error{
          .code = ErrorCode::EdgeOutOfRange, .edge = edge, .value = double(index.edgeCount())};
    }
    if (!seen.insert(edge).second) return Error{.code = ErrorCode::EdgePickedTwice, .edge = edge};
  }
  return std::nullopt;
}

Result<std::set<int>> positionsOf(const BorderGraph& graph, std::vector<int> edges) {
  std::sort(edges.begin(), edges.end());
  std::set<int> positions;
  for (int edge : edges) {
    if (graph.find(edge) < 0) return fail(graph.refusal(edge));
    positions.insert(graph.find(edge));
  }
  return positions;
}

double headingBalance(const BorderGraph& graph, const std::vector<LoopEdge>& walk) {
  double balance = 0.0;
  for (const LoopEdge& e : walk) {
    const BorderEdge& edge = graph.edges()[std::size_t(e.border)];
    if (edge.heading) balance += *edge.heading == e.direction ? edge.length : -edge.length;
  }
  return balance;
}

void turnRound(std::vector<LoopEdge>& walk) {
  std::reverse(walk.begin(), walk.end());
  for (LoopEdge& e : walk) e.direction = opposite(e.direction);
}

}  // namespace fairing::occt
