// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace fairing::layout {

// The four edges of a patch, in the order and direction of its border:
//
//        North (u falls)
//     3------<------2
//     |             |
//  W  v             ^  East (v rises)
//     |             |
//     0------>------1
//        South (u rises)
enum class PatchEdge { South, East, North, West };

inline constexpr std::array<PatchEdge, 4> kPatchEdges{
    PatchEdge::South, PatchEdge::East, PatchEdge::North, PatchEdge::West};

/// A quadrilateral of the hole: corners 0 to 3 counter-clockwise, edge k from corner k to the next.
struct Quad {
  std::array<int, 4> vertices{};
  std::array<int, 4> sides{-1, -1, -1, -1};  ///< the side of the loop an edge covers, -1 = a seam
};

/// An edge of a quad.
struct QuadEdge {
  int quad = 0;
  PatchEdge edge = PatchEdge::South;
};

/// Two quads that share an edge: seen along `first`, `second` lies to the right and runs backwards.
struct QuadSeam {
  QuadEdge first, second;
  int start = 0, end = 0;  ///< vertices, along `first`
};

/// How a hole is divided into quads: topology, and a planar picture of it whose lengths and angles
/// tell the seams where to leave their ends.
struct QuadMesh {
  std::vector<Quad> quads;
  std::vector<Eigen::Vector2d> vertices;  ///< in the picture, mm; empty: `ways` tells it all
  std::vector<char> inside;               ///< a flag per vertex: not on the loop
  /// Where no single picture shows the mesh: ways along its edges in pictures about the vertices
  /// they leave, mm.
  std::map<std::pair<int, int>, Eigen::Vector2d> ways;

  /// The way along an edge, in the picture about the vertex it leaves.
  [[nodiscard]] Eigen::Vector2d way(int from, int to) const;
  [[nodiscard]] std::vector<QuadSeam> seams() const;
};

/// A direction of a quad (0 = u, 1 = v) belongs to a strip: all quads that must share its knots,
/// since they are passed one after the other across opposite edges.
struct StripUse {
  int strip = 0;
  bool reversed = false;  ///< the quad's parameter runs against the strip's
};

/// The strips of every quad, u and v.
struct Strips {
  int count = 0;
  std::vector<std::array<StripUse, 2>> uses;  ///< per quad
};
[[nodiscard]] Strips stripsOf(const QuadMesh& mesh);

/// 0 where an edge runs along u, 1 along v.
[[nodiscard]] constexpr std::size_t directionOf(PatchEdge edge) {
  return edge == PatchEdge::South || edge == PatchEdge::North ? 0 : 1;
}
/// Whether the parameter falls along an edge in the border's direction.
[[nodiscard]] constexpr bool falls(PatchEdge edge) {
  return edge == PatchEdge::North || edge == PatchEdge::West;
}

}  // namespace fairing::layout
