// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/loop_walk.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fairing::occt {
namespace {

using Eigen::Vector3d;

/// Two ways that differ by less (radians) cannot be told apart.
constexpr double kSameWay = 0.02;
/// Share of an edge at which its direction from a node is taken: the chord is robust where the
/// curve starts oddly.
constexpr double kChord = 0.02;

}  // namespace

LoopWalk::LoopWalk(const ShapeIndex& index, const BorderGraph& graph, std::set<int> picked)
    : index_(index),
      graph_(graph),
      picked_(std::move(picked)),
      dangling_(graph.edges().size(), false) {
  // A lone edge that ends nowhere is a drawing aid, not a border. Repeated, since chains of them
  // unravel.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < dangling_.size(); ++i) {
      const BorderEdge& edge = graph_.edges()[i];
      if (dangling_[i] || edge.support || edge.heading || picked_.contains(int(i))) continue;
      const auto isEnd = [&](int node) {
        const auto& there = graph_.at(node);
        return std::count_if(there.begin(), there.end(), [&](int k) {
                 return !dangling_[std::size_t(k)];
               }) < 2;
      };
      if (isEnd(edge.nodes[0]) || isEnd(edge.nodes[1])) changed = dangling_[i] = true;
    }
  }
}

std::vector<LoopEdge> LoopWalk::leaving(int node, const std::set<int>& used, int start) const {
  std::vector<LoopEdge> ways;
  for (int i : std::set<int>(graph_.at(node).begin(), graph_.at(node).end())) {
    if (dangling_[std::size_t(i)] || (used.contains(i) && i != start)) continue;
    for (Direction d : {Direction::Forward, Direction::Backward}) {
      if (graph_.edges()[std::size_t(i)].from(d) == node) ways.push_back({i, d});
    }
  }
  return ways;
}

Vector3d LoopWalk::normalAt(int node, const std::vector<LoopEdge>& edges) const {
  Vector3d sum = Vector3d::Zero();
  for (const LoopEdge& way : edges) {
    const BorderEdge& border = graph_.edges()[std::size_t(way.border)];
    if (!border.support) continue;
    const EdgeCurve curve(index_.edge(border.edge), Direction::Forward);
    const EdgeSupport support(
        index_.face(border.support->face), border.support->edge, border.match, NormalSense::AsFace);
    const double t = border.nodes[0] == node ? 0.0 : 1.0;
    const auto sample = support.at(curve.parameter(t), curve.point(t));
    if (!sample.singular) sum += sample.normal;
  }
  return sum;
}

// The hole lies to the left. Seen from the normal, with the way back as zero, the angle grows
// clockwise through the hole:
//
//        back  <----- node        the next border of the same gap is the first edge met
//                    / hole
//                next
Result<LoopEdge> LoopWalk::chooseByAngle(const LoopEdge& arrived,
                                         const std::vector<LoopEdge>& ways) const {
  const BorderEdge& last = graph_.edges()[std::size_t(arrived.border)];
  const int node = last.to(arrived.direction);
  const Error unclear{
      .code = ErrorCode::LoopBranches, .edge = last.edge, .where = graph_.point(node)};
  std::vector<LoopEdge> all = ways;
  all.push_back(arrived);
  const Vector3d normal = normalAt(node, all);
  if (normal.norm() < 1e-3) return fail(unclear);
  const Vector3d n = normal.normalized();
  const auto chord = [&](const LoopEdge& way) -> Vector3d {
    const EdgeCurve curve(index_.edge(graph_.edges()[std::size_t(way.border)].edge), way.direction);
    const Vector3d d = curve.point(kChord) - curve.point(0.0);
    return d - n * n.dot(d);
  };
  const Vector3d back = chord({arrived.border, opposite(arrived.direction)});
  struct Way {
    double angle;
    LoopEdge edge;
  };
  std::vector<Way> sorted;
  for (const LoopEdge& way : ways) {
    const Vector3d d = chord(way);
    double angle = -std::atan2(back.cross(d).dot(n), back.dot(d));
    if (angle <= kSameWay) angle += 2.0 * std::numbers::pi;
    sorted.push_back({angle, way});
  }
  std::sort(
      sorted.begin(), sorted.end(), [](const Way& a, const Way& b) { return a.angle < b.angle; });
  if (sorted[1].angle - sorted[0].angle < kSameWay) return fail(unclear);
  return sorted[0].edge;
}

Result<LoopEdge> LoopWalk::choose(const LoopEdge& arrived, std::vector<LoopEdge> ways) const {
  if (ways.size() == 1) return ways.front();
  const auto keepIf = [&](auto wanted) {
    std::vector<LoopEdge> kept;
    std::copy_if(ways.begin(), ways.end(), std::back_inserter(kept), wanted);
    if (!kept.empty()) ways = std::move(kept);
  };
  keepIf([&](const LoopEdge& way) { return picked_.contains(way.border); });
  keepIf([&](const LoopEdge& way) {
    const auto& heading = graph_.edges()[std::size_t(way.border)].heading;
    return !heading || *heading == way.direction;
  });
  if (ways.size() == 1) return ways.front();
  return chooseByAngle(arrived, ways);
}

Error LoopWalk::deadEnd(const LoopEdge& arrived) const {
  const BorderEdge& last = graph_.edges()[std::size_t(arrived.border)];
  const int node = last.to(arrived.direction);
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < graph_.edges().size(); ++i) {
    for (int other : graph_.edges()[i].nodes) {
      if (other == node || graph_.at(other).size() != 1) continue;
      // The far end of the same edge counts only when nothing else does.
      if (int(i) == arrived.border && std::isfinite(gap)) continue;
      const double distance = (graph_.point(other) - graph_.point(node)).norm();
      gap = std::min(gap, distance);
    }
  }
  return {.code = ErrorCode::LoopNotClosed,
          .edge = last.edge,
          .where = graph_.point(node),
          .value = std::isfinite(gap) ? gap : 0.0};
}

double LoopWalk::lengthOf(const std::vector<LoopEdge>& loop) const {
  double length = 0.0;
  for (const LoopEdge& e : loop) length += graph_.edges()[std::size_t(e.border)].length;
  return length;
}

Result<std::vector<LoopEdge>> LoopWalk::from(int border) const {
  const auto& heading = graph_.edges()[std::size_t(border)].heading;
  if (heading) return follow({border, *heading});
  auto one = follow({border, Direction::Forward});
  auto other = follow({border, Direction::Backward});
  if (one && other) return lengthOf(*other) < lengthOf(*one) ? other : one;
  return other ? other : one;
}

Result<std::vector<LoopEdge>> LoopWalk::follow(const LoopEdge& start) const {
  const int border = start.border;
  const BorderEdge& first = graph_.edges()[std::size_t(border)];
  std::vector<LoopEdge> loop{start};
  std::set<int> used{border};
  std::set<int> passed{first.from(start.direction)};
  while (true) {
    const LoopEdge& last = loop.back();
    const int node = graph_.edges()[std::size_t(last.border)].to(last.direction);
    std::vector<LoopEdge> ways = leaving(node, used, border);
    // Turning back along the start is no way on.
    std::erase_if(ways, [&](const LoopEdge& way) {
      return way.border == border && way.direction != start.direction;
    });
    if (ways.empty()) return fail(deadEnd(last));
    const auto next = choose(last, std::move(ways));
    if (!next) return fail(next.error());
    if (next->border == border) return loop;
    if (!passed.insert(node).second) {
      return fail({.code = ErrorCode::LoopSelfTouching,
                   .edge = graph_.edges()[std::size_t(next->border)].edge,
                   .where = graph_.point(node)});
    }
    used.insert(next->border);
    loop.push_back(*next);
  }
}

}  // namespace fairing::occt
