// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

namespace fairing::analysis {

/// Triangles that share points where they are neighbours.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Whether triangles that only touch, within 1e-7 of an edge's length, count as cut.
enum class Touches { Count, DoNotCount };

/// Triangles in a tree of boxes, halved along their longest extent.
class TriangleTree {
 public:
  explicit TriangleTree(TriangleMesh mesh);

  /// Points in which triangles of two trees cut through each other: where an edge of one pierces
  /// the other. Triangles that lie in one plane do not cut.
  [[nodiscard]] std::vector<Eigen::Vector3d> crossings(const TriangleTree& other,
                                                       Touches touches) const;
  /// The same among the triangles of one tree, touches counted; neighbours, which share a point,
  /// are left out.
  [[nodiscard]] std::vector<Eigen::Vector3d> ownCrossings() const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int first = 0, count = 0;  // triangles in order_, of a leaf
    int left = -1, right = -1;
    [[nodiscard]] bool isLeaf() const { return left < 0; }
  };
  int build(int first, int count);
  [[nodiscard]] std::array<Eigen::Vector3d, 3> corners(int triangle) const;
  [[nodiscard]] const Eigen::AlignedBox3d& boxAt(int place) const {  // in order_
    return boxes_[static_cast<std::size_t>(order_[static_cast<std::size_t>(place)])];
  }
  [[nodiscard]] bool areNeighbours(int a, int b) const;
  template <class Visit>
  static void eachPair(const TriangleTree& a, const TriangleTree& b, const Visit& visit);

  TriangleMesh mesh_;
  std::vector<Eigen::AlignedBox3d> boxes_;  // of the triangles
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

/// What crossings amount to: the one nearest to their middle, and the largest extent of them all.
struct CrossingSize {
  Eigen::Vector3d where;
  double extent = 0.0;  ///< mm
};
[[nodiscard]] std::optional<CrossingSize> sizeOf(const std::vector<Eigen::Vector3d>& crossings);

}  // namespace fairing::analysis
