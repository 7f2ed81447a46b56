// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/coincidence.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <map>
#include <numeric>

#include "occt/from_occt.h"

namespace fairing::occt {
namespace {

using Eigen::Vector3d;

/// Ends this close, relative to the size of all candidate edges, belong together even where the
/// tolerances say less.
constexpr double kJoin = 1e-5;
/// ... but never so that an edge could collapse: this share of the shorter edge is the limit.
constexpr double kJoinOfEdge = 0.1;

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

/// The distance within which things lie together: kJoin of the box around all samples.
double nearDistance(const std::vector<Candidate>& candidates) {
  if (candidates.empty()) return 0.0;
  Vector3d low = candidates.front().samples.front();
  Vector3d high = low;
  for (const Candidate& c : candidates) {
    for (const Vector3d& p : c.samples) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return kJoin * (high - low).norm();
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
UnionFind joinPoints(const std::vector<EndPoint>& ends, double near) {
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

/// Whether the samples of both edges lie together one by one, in the same or in opposite order.
bool samplesMatch(const Candidate& a, const Candidate& b, double allowed) {
  const auto match = [&](auto first) {
    return std::equal(a.samples.begin(), a.samples.end(), first, [&](const auto& p, const auto& q) {
      return (p - q).norm() <= allowed;
    });
  };
  return match(b.samples.begin()) || match(b.samples.rbegin());
}

/// Whether the inner samples of one edge lie on the other.
bool coincide(const ShapeIndex& index, const Candidate& a, const Candidate& b, double near) {
  if (std::abs(a.length - b.length) > 0.1 * std::max(a.length, b.length)) return false;
  const double allowed =
      std::min(std::max(near, a.tolerance + b.tolerance), kJoinOfEdge * a.length);
  if (samplesMatch(a, b, allowed)) return true;
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

std::vector<Vector3d> joinEnds(const ShapeIndex& index, std::vector<Candidate>& candidates) {
  const std::vector<EndPoint> ends = collectEnds(index, candidates);
  UnionFind nodes = joinPoints(ends, nearDistance(candidates));
  for (Candidate& c : candidates) {
    for (int& end : c.ends) end = nodes.root(end);
  }
  std::vector<Vector3d> points;
  for (const EndPoint& end : ends) points.push_back(end.point);
  return points;
}

std::vector<std::vector<int>> groupsOfTwins(const ShapeIndex& index,
                                            const std::vector<Candidate>& candidates) {
  UnionFind twins = joinTwins(index, candidates, nearDistance(candidates));
  std::map<int, std::vector<int>> byRoot;
  for (std::size_t i = 0; i < candidates.size(); ++i) byRoot[twins.root(int(i))].push_back(int(i));
  std::vector<std::vector<int>> groups;
  for (auto& [root, group] : byRoot) groups.push_back(std::move(group));
  return groups;
}

}  // namespace fairing::occt
