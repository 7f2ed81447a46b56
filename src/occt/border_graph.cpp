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
  EdgeMatch match = EdgeMatch::Same;
};

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

/// Sorts the uses of an edge into those that stay and the one that goes; an error where no hole can
/// run along it.
Result<Candidate> candidate(const ShapeIndex& index, int number, const std::set<int>& pickedFaces) {
  const TopoDS_Edge& edge = index.edge(number);
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
  const int faces = int(index.uses(number).size());
  const bool degenerate = BRep_Tool::Degenerated(edge);
  if (!degenerate) {
    if (!EdgeCurve(edge, Direction::Forward).isFinite()) {
      return fail({.code = ErrorCode::EdgeInfinite, .edge = number});
    }
    measure(edge, c);
  }
  if (degenerate || !(c.length > 1e-3 * Precision::Confusion())) {
    Error error{.code = ErrorCode::EdgeDegenerate, .edge = number, .value = c.length};
    const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
    if (!vertex.IsNull()) error.where = fromOcct(BRep_Tool::Pnt(vertex));
    return fail(error);
  }
  c.walkable = pickedFaces.empty() ? faces <= 1 : removals == 1;
  if (c.staying.size() > (removals > 0 ? 1U : 2U)) {
    return fail({.code = ErrorCode::EdgeWithManyFaces, .edge = number, .value = double(faces)});
  }
  if (c.staying.size() > 1 || removals > 1) {
    return fail({.code = ErrorCode::EdgeNotFree, .edge = number, .value = double(faces)});
  }
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
    graph.refusals_[std::size_t(number)] = {
        .code = ErrorCode::EdgeNotFree, .edge = number, .value = double(index.uses(number).size())};
    auto c = candidate(index, number, pickedFaces);
    if (c) {
      candidates.push_back(std::move(*c));
    } else {
      graph.refusals_[std::size_t(number)] = c.error();
    }
  }

  const double near = kJoin * boxDiagonal(candidates);
  const std::vector<EndPoint> ends = collectEnds(index, candidates);
  UnionFind nodes = joinEnds(ends, near);
  for (Candidate& c : candidates) {
    for (int& end : c.ends) end = nodes.root(end);
  }

  UnionFind twins = joinTwins(index, candidates, near);
  std::map<int, std::vector<int>> groups;
  for (std::size_t i = 0; i < candidates.size(); ++i) groups[twins.root(int(i))].push_back(int(i));
  for (const auto& [root, group] : groups) {
    std::vector<EdgeUse> faces;
    for (int i : group) {
      const Candidate& c = candidates[std::size_t(i)];
      faces.insert(faces.end(), c.staying.begin(), c.staying.end());
    }
    // A free edge with a coincident lone one: the face's edge speaks for both, unless only the lone
    // one was picked.
    const auto rank = [&](int i) {
      const Candidate& c = candidates[std::size_t(i)];
      return std::tuple(
          !c.walkable, !pickedEdges.contains(c.edge), c.staying.empty() && !c.removed, c.edge);
    };
    const int chosen = *std::min_element(
        group.begin(), group.end(), [&](int a, int b) { return rank(a) < rank(b); });
    Candidate& c = candidates[std::size_t(chosen)];
    if (!c.walkable) continue;
    const std::size_t limit = 1;
    if (faces.size() > limit) {
      for (int i : group) {
        Error& error = graph.refusals_[std::size_t(candidates[std::size_t(i)].edge)];
        error.code = faces.size() > 2 ? ErrorCode::EdgeWithManyFaces : ErrorCode::EdgeNotFree;
        error.value = double(faces.size());
      }
      continue;
    }
    BorderEdge border{.edge = c.edge, .nodes = c.ends, .length = c.length};
    const bool lone = c.staying.empty() && !c.removed;
    if (!c.staying.empty()) {
      border.support = c.staying.front();
    } else if (!faces.empty() && !lone) {
      border.support = faces.front();
      border.match = EdgeMatch::Twin;
    }
    // The hole lies opposite to the face that stays, or where the removed face was.
    if (border.support && border.match == EdgeMatch::Same) {
      const bool reversed = border.support->edge.Orientation() == TopAbs_REVERSED;
      border.heading = reversed ? Direction::Forward : Direction::Backward;
    } else if (c.removed) {
      const bool reversed = c.removed->edge.Orientation() == TopAbs_REVERSED;
      border.heading = reversed ? Direction::Backward : Direction::Forward;
    }
    for (int i : group) {
      graph.position_[std::size_t(candidates[std::size_t(i)].edge)] = int(graph.edges_.size());
    }
    graph.edges_.push_back(std::move(border));
  }

  graph.incident_.resize(ends.size());
  for (const EndPoint& end : ends) graph.points_.push_back(end.point);
  for (std::size_t i = 0; i < graph.edges_.size(); ++i) {
    for (int node : graph.edges_[i].nodes) graph.incident_[std::size_t(node)].push_back(int(i));
  }
  return graph;
}

}  // namespace fairing::occt
