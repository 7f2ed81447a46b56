// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/triangle_crossing.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace fairing::analysis {
namespace {

using Eigen::Vector3d;
using Corners = std::array<Vector3d, 3>;

constexpr int kLeaf = 4;
// A cut this close to an end of the edge, or to the border of the triangle, is a touch.
constexpr double kTouch = 1e-7;

// Where the edge from p to q pierces a triangle [MoellerTrumbore1997].
std::optional<Vector3d> piercing(const Vector3d& p,
                                 const Vector3d& q,
                                 const Corners& t,
                                 Touches touches) {
  const double least = touches == Touches::Count ? -kTouch : kTouch;
  const Vector3d way = q - p, a = t[1] - t[0], b = t[2] - t[0];
  const Vector3d cross = way.cross(b);
  const double volume = a.dot(cross);
  if (std::abs(volume) <= kTouch * way.norm() * a.cross(b).norm()) return std::nullopt;
  const Vector3d from = p - t[0];
  const double u = from.dot(cross) / volume;
  const Vector3d side = from.cross(a);
  const double v = way.dot(side) / volume, s = b.dot(side) / volume;
  const bool inside = u > least && v > least && u + v < 1.0 - least;
  if (!inside || s <= least || s >= 1.0 - least) return std::nullopt;
  return p + s * way;
}

void addPiercings(const Corners& edges,
                  const Corners& triangle,
                  Touches touches,
                  std::vector<Vector3d>& found) {
  for (std::size_t k = 0; k < 3; ++k)
    if (const auto point = piercing(edges[k], edges[(k + 1) % 3], triangle, touches))
      found.push_back(*point);
}

}  // namespace

TriangleTree::TriangleTree(TriangleMesh mesh) : mesh_(std::move(mesh)) {
  order_.resize(mesh_.triangles.size());
  std::iota(order_.begin(), order_.end(), 0);
  for (const int triangle : order_) {
    boxes_.emplace_back();
    for (const Vector3d& corner : corners(triangle)) boxes_.back().extend(corner);
  }
  if (!order_.empty()) build(0, static_cast<int>(order_.size()));
}

Corners TriangleTree::corners(int triangle) const {
  const auto& t = mesh_.triangles[static_cast<std::size_t>(triangle)];
  const auto at = [&](int k) { return mesh_.points[static_cast<std::size_t>(k)]; };
  return {at(t[0]), at(t[1]), at(t[2])};
}

int TriangleTree::build(int first, int count) {
  const int number = static_cast<int>(nodes_.size());
  Node node{{}, first, count, -1, -1};
  const auto boxOf = [&](int triangle) -> const Eigen::AlignedBox3d& {
    return boxes_[static_cast<std::size_t>(triangle)];
  };
  for (int k = first; k < first + count; ++k)
    node.box.extend(boxOf(order_[static_cast<std::size_t>(k)]));
  nodes_.push_back(node);
  if (count <= kLeaf) return number;
  Eigen::Index axis = 0;
  node.box.sizes().maxCoeff(&axis);
  const int half = count / 2;
  std::nth_element(order_.begin() + first,
                   order_.begin() + first + half,
                   order_.begin() + first + count,
                   [&](int a, int b) { return boxOf(a).center()[axis] < boxOf(b).center()[axis]; });
  const int left = build(first, half), right = build(first + half, count - half);
  nodes_[static_cast<std::size_t>(number)].left = left;
  nodes_[static_cast<std::size_t>(number)].right = right;
  return number;
}

bool TriangleTree::areNeighbours(int a, int b) const {
  const auto &s = mesh_.triangles[static_cast<std::size_t>(a)],
             &t = mesh_.triangles[static_cast<std::size_t>(b)];
  return std::any_of(s.begin(), s.end(), [&](int point) {
    return std::find(t.begin(), t.end(), point) != t.end();
  });
}

// Every pair of triangles whose boxes meet.
template <class Visit>
void TriangleTree::eachPair(const TriangleTree& a, const TriangleTree& b, const Visit& visit) {
  if (a.nodes_.empty() || b.nodes_.empty()) return;
  std::vector<std::pair<int, int>> waiting{{0, 0}};
  while (!waiting.empty()) {
    const auto [i, j] = waiting.back();
    waiting.pop_back();
    const Node &m = a.nodes_[static_cast<std::size_t>(i)],
               &n = b.nodes_[static_cast<std::size_t>(j)];
    if (!m.box.intersects(n.box)) continue;
    if (&m == &n && !m.isLeaf()) {  // of one tree: every pair once
      waiting.insert(waiting.end(), {{m.left, m.left}, {m.left, m.right}, {m.right, m.right}});
      continue;
    }
    if (m.isLeaf() && n.isLeaf()) {
      for (int s = m.first; s < m.first + m.count; ++s)
        for (int t = n.first; t < n.first + n.count; ++t)
          if (a.boxAt(s).intersects(b.boxAt(t)) && (&m != &n || s < t))
            visit(a.order_[static_cast<std::size_t>(s)], b.order_[static_cast<std::size_t>(t)]);
    } else if (n.isLeaf() || (!m.isLeaf() && m.count >= n.count)) {
      waiting.emplace_back(m.left, j);
      waiting.emplace_back(m.right, j);
    } else {
      waiting.emplace_back(i, n.left);
      waiting.emplace_back(i, n.right);
    }
  }
}

std::vector<Vector3d> TriangleTree::crossings(const TriangleTree& other, Touches touches) const {
  std::vector<Vector3d> found;
  eachPair(*this, other, [&](int s, int t) {
    const Corners a = corners(s), b = other.corners(t);
    addPiercings(a, b, touches, found);
    addPiercings(b, a, touches, found);
  });
  return found;
}

std::vector<Vector3d> TriangleTree::ownCrossings() const {
  std::vector<Vector3d> found;
  eachPair(*this, *this, [&](int s, int t) {
    if (areNeighbours(s, t)) return;
    addPiercings(corners(s), corners(t), Touches::Count, found);
    addPiercings(corners(t), corners(s), Touches::Count, found);
  });
  return found;
}

std::optional<CrossingSize> sizeOf(const std::vector<Vector3d>& crossings) {
  if (crossings.empty()) return std::nullopt;
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : crossings) box.extend(point);
  const Vector3d middle = box.center();
  const auto nearer = [&](const Vector3d& a, const Vector3d& b) {
    return (a - middle).squaredNorm() < (b - middle).squaredNorm();
  };
  return CrossingSize{*std::min_element(crossings.begin(), crossings.end(), nearer),
                      box.diagonal().norm()};
}

}  // namespace fairing::analysis
