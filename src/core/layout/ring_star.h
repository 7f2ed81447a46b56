// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/boundary/cut_loop.h"
#include "core/layout/quad_mesh.h"

namespace fairing::layout {

/// The border of a star whose corners need not lie on sides: spoke end, corner, spoke end, ...,
/// counter-clockwise.
struct StarBorder {
  std::vector<int> vertices;
  /// The side from vertex k to the next one; -1: a free edge, or a seam of another star.
  std::vector<int> sides;

  void add(int vertex, int side = -1) {
    vertices.push_back(vertex);
    sides.push_back(side);
  }
};

/// A mesh of stars between chains. No picture shows all of it: it holds ways about every inner
/// vertex, and these need the vertices' places in space, of inner ones as good as guessed.
class RingMesh {
 public:
  /// Vertices from `firstInside` on lie inside, or in the middle of a free edge.
  RingMesh(std::vector<Eigen::Vector3d> points, int firstInside);

  /// A quad a corner round a vertex; the ways about that one.
  void addStar(const StarBorder& border, int centre);
  /// A vertex where the way from `before` goes straight on to `after`, and what leaves to its left
  /// and right does so crosswise.
  void showCrossing(int vertex,
                    int before,
                    int after,
                    const std::vector<int>& left,
                    const std::vector<int>& right = {});
  [[nodiscard]] QuadMesh take() { return std::move(mesh_); }

 private:
  void show(int from, int to, const Eigen::Vector2d& direction);

  std::vector<Eigen::Vector3d> points_;
  QuadMesh mesh_;
};

/// Where the middle of a free curve lies between the end of one side and the start of another that
/// leaves either of them into the gap.
[[nodiscard]] Eigen::Vector3d middleOfWay(const boundary::BoundarySide& from,
                                          double t,
                                          const boundary::BoundarySide& to);

}  // namespace fairing::layout
