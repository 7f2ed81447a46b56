// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/border_graph.h"

#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "occt/from_occt.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

using Eigen::Vector3d;

/// Ends this close, relative to the size of all candidate edges, belong together even where the
/// tolerances say less.
constexpr double kJoin = 1e-5;
/// ... but never so that an edge could collapse: this share of the shorter edge is the limit.
constexpr double kJoinOfEdge = 0.1;
constexpr int kSamples = 8;

/// An edge with at most one face that stays, before ends and coincident edges are matched.
struct Candidate {
  int edge = 0;
  std::vector<EdgeUse> staying = {};    ///< at most one before twins are joined
  std::optional<EdgeUse> removed = {};  ///< by the picked face
  bool walkable = false;
  std::array<int, 2> ends{};  ///< indices of end points
  std::vector<Vector3d> samples = {};
  double length = 0.0;
  double tolerance = 0.0;

  [[nodiscard]] bool isLone() const { return staying.empty() && !removed; }
};

/// The refusal of an edge that borders no hole.
Error notFree(int edge, std::size_t faces) {
  return {.code = faces > 2 ? ErrorCode::EdgeWithManyFaces : ErrorCode::EdgeNotFree,
          .edge = edge,
          .value = double(faces)};
}

struct EndPoint {
  Vector3d point;
  double tolerance;  ///< of its vertex
  double reach;      ///< the furthest it may be moved
};

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int i) {
    while (parent_[std::size_t(i)] != i)
      i = parent_[std::size_t(i)] = parent_[std::size_t(parent_[std::size_t(i)])];
    return i;
  }
  /// The smaller index stays the root, so that numbering does not depend on the order of joins.
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

double boxDiagonal(const std::vector<Candidate>& candidates) {
  if (candidates.empty()) return 0.0;
  Vector3d low = candidates.front().samples.front();
  Vector3d high = low;
  for (const Candidate& c : candidates) {
    for (const Vector3d& p : c.samples) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return (high - low).norm();
}

void measure(const TopoDS_Edge& edge, Candidate& c) {
  const EdgeCurve curve(edge, Direction::Forward);
  for (int i = 0; i <= kSamples; ++i) {
    c.samples.push_back(curve.point(double(i) / kSamples));
    if (i > 0) c.length += (c.samples[std::size_t(i)] - c.samples[std::size_t(i - 1)]).norm();
  }
  c.tolerance = BRep_Tool::Tolerance(edge);
}

Error degenerate(int number, const TopoDS_Edge& edge, double length) {
  Error error{.code = ErrorCode::EdgeDegenerate, .edge = number, .value = length};
  const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
  if (!vertex.IsNull()) error.where = fromOcct(BRep_Tool::Pnt(vertex));
  return error;
}

/// Sorts the uses of an edge into those that stay and the one that goes; an error where no hole can
/// run along it.
Result<Candidate> candidate(const ShapeIndex& index, int number, const std::set<int>& pickedFaces) {
  const TopoDS_Edge& edge = index.edge(number);
  if (BRep_Tool::Degenerated(edge)) return fail(degenerate(number, edge, 0.0));
  Candidate c{.edge = number};
  int removals = 0;
  for (const EdgeUse& use : index.uses(number)) {
    if (pickedFaces.contains(use.face)) {
      c.removed = use;
      ++removals;
    } else {
      c.staying.push_back(use);
    }
  }
  const std::size_t faces = index.uses(number).size();
  if (c.staying.size() > 1 || removals > 1) return fail(notFree(number, faces));
  if (!EdgeCurve(edge, Direction::Forward).isFinite()) {
    return fail({.code = ErrorCode::EdgeInfinite, .edge = number});
  }
  measure(edge, c);
  if (!(c.length > 1e-3 * Precision::Confusion())) return fail(degenerate(number, edge, c.length));
  c.walkable = pickedFaces.empty() ? faces <= 1 : removals == 1;
  return c;
}

/// Ends as points: shared vertices are one point from the start.
std::vector<EndPoint> collectEnds(const ShapeIndex& index, std::vector<Candidate>& candidates) {
  std::vector<EndPoint> ends;
  TopTools_IndexedMapOfShape vertices;
  std::map<int, int> endOfVertex;
  for (Candidate& c : candidates) {
    const TopoDS_Edge forward = TopoDS::Edge(index.edge(c.edge).Oriented(TopAbs_FORWARD));
    const std::array<TopoDS_Vertex, 2> own{TopExp::FirstVertex(forward),
                                           TopExp::LastVertex(forward)};
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector3d& curveEnd = k == 0 ? c.samples.front() : c.samples.back();
      const double reach = kJoinOfEdge * c.length;
      if (own[k].IsNull()) {
        c.ends[k] = int(ends.size());
        ends.push_back({curveEnd, c.tolerance, reach});
        continue;
      }
      const auto [it, isNew] = endOfVertex.try_emplace(vertices.Add(own[k]), int(ends.size()));
      if (isNew) {
        ends.push_back({fromOcct(BRep_Tool::Pnt(own[k])), BRep_Tool::Tolerance(own[k]), reach});
      }
      c.ends[k] = it->second;
      EndPoint& end = ends[std::size_t(it->second)];
      end.reach = std::min(end.reach, reach);
    }
  }
  return ends;
}

/// Joins separate ends that lie within their tolerances or within `near` of each other. A sweep
/// along x.
UnionFind joinEnds(const std::vector<EndPoint>& ends, double near) {
  UnionFind nodes(ends.size());
  std::vector<int> order(ends.size());
  std::iota(order.begin(), order.end(), 0);
  const auto x = [&](int i) { return ends[std::size_t(i)].point.x(); };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return x(a) < x(b); });
  double widest = near;
  for (const EndPoint& end : ends) widest = std::max(widest, 2.0 * end.tolerance);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const EndPoint& a = ends[std::size_t(order[i])];
    for (std::size_t j = i + 1; j < order.size() && x(order[j]) - a.point.x() <= widest; ++j) {
      const EndPoint& b = ends[std::size_t(order[j])];
      const double allowed =
          std::min({std::max(near, a.tolerance + b.tolerance), a.reach, b.reach});
      if ((a.point - b.point).norm() <= allowed) nodes.join(order[i], order[j]);
    }
  }
  return nodes;
}

/// Whether the inner samples of one edge lie on the other.
bool coincide(const ShapeIndex& index, const Candidate& a, const Candidate& b, double near) {
  if (std::abs(a.length - b.length) > 0.1 * std::max(a.length, b.length)) return false;
  const double allowed =
      std::min(std::max(near, a.tolerance + b.tolerance), kJoinOfEdge * a.length);
  const BRepAdaptor_Curve other(index.edge(b.edge));
  for (std::size_t i = 1; i < a.samples.size() - 1; ++i) {
    const Extrema_ExtPC feet(toPoint(a.samples[i]), other);
    double nearest = std::min((a.samples[i] - b.samples.front()).squaredNorm(),
                              (a.samples[i] - b.samples.back()).squaredNorm());
    for (int k = 1; feet.IsDone() && k <= feet.NbExt(); ++k) {
      nearest = std::min(nearest, feet.SquareDistance(k));
    }
    if (nearest > allowed * allowed) return false;
  }
  return true;
}

/// Groups of coincident candidates. Closed edges may start elsewhere, so these are compared among
/// each other.
UnionFind joinTwins(const ShapeIndex& index,
                    const std::vector<Candidate>& candidates,
                    double near) {
  UnionFind twins(candidates.size());
  std::map<std::pair<int, int>, std::vector<int>> byEnds;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    auto [a, b] = candidates[i].ends;
    const bool closed = a == b;
    byEnds[closed ? std::pair{-1, -1} : std::pair{std::min(a, b), std::max(a, b)}].push_back(
        int(i));
  }
  for (const auto& [ends, group] : byEnds) {
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (std::size_t j = i + 1; j < group.size(); ++j) {
        const auto& a = candidates[std::size_t(group[i])];
        const auto& b = candidates[std::size_t(group[j])];
        if (coincide(index, a, b, near)) twins.join(group[i], group[j]);
      }
    }
  }
  return twins;
}

/// Positions of coincident candidates, group by group.
std::vector<std::vector<int>> groupsOfTwins(const ShapeIndex& index,
                                            const std::vector<Candidate>& candidates,
                                            double near) {
  UnionFind twins = joinTwins(index, candidates, near);
  std::map<int, std::vector<int>> byRoot;
  for (std::size_t i = 0; i < candidates.size(); ++i) byRoot[twins.root(int(i))].push_back(int(i));
  std::vector<std::vector<int>> groups;
  for (auto& [root, group] : byRoot) groups.push_back(std::move(group));
  return groups;
}

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
  const std::set<int> pickedFaces(picks.faces.begin(), picks.faces.end());
  const std::set<int> pickedEdges(picks.edges.begin(), picks.edges.end());
  BorderGraph graph;
  const auto slots = std::size_t(index.edgeCount()) + 1;
  graph.position_.assign(slots, -1);
  graph.refusals_.resize(slots);

  std::vector<Candidate> candidates;
  for (int number = 1; number <= index.edgeCount(); ++number) {
    auto c = guarded([&] { return candidate(index, number, pickedFaces); });
    graph.refusals_[std::size_t(number)] =
        c ? notFree(number, index.uses(number).size()) : c.error();
    if (c) candidates.push_back(std::move(*c));
  }

  const double near = kJoin * boxDiagonal(candidates);
  const std::vector<EndPoint> ends = collectEnds(index, candidates);
  UnionFind nodes = joinEnds(ends, near);
  for (Candidate& c : candidates) {
    for (int& end : c.ends) end = nodes.root(end);
  }

  for (const std::vector<int>& positions : groupsOfTwins(index, candidates, near)) {
    std::vector<const Candidate*> group;
    for (int i : positions) group.push_back(&candidates[std::size_t(i)]);
    const Candidate& chosen = spokesman(group, pickedEdges);
    const std::vector<EdgeUse> faces = stayingFaces(group);
    if (!chosen.walkable) continue;
    for (const Candidate* c : group) {
      const auto slot = std::size_t(c->edge);
      if (faces.size() > 1)
        graph.refusals_[slot] = notFree(c->edge, faces.size());
      else
        graph.position_[slot] = int(graph.edges_.size());
    }
    if (faces.size() <= 1) graph.edges_.push_back(borderOf(chosen, faces));
  }
  graph.connect(ends.size());
  for (const EndPoint& end : ends) graph.points_.push_back(end.point);
  return graph;
}

void BorderGraph::connect(std::size_t nodeCount) {
  incident_.resize(nodeCount);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    for (int node : edges_[i].nodes) incident_[std::size_t(node)].push_back(int(i));
  }
}

}  // namespace fairing::occt
