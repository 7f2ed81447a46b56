// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <set>
#include <vector>

#include "core/base/result.h"
#include "occt/edge_curve.h"
#include "occt/edge_support.h"
#include "occt/picks.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// An edge along which a hole may run.
struct BorderEdge {
  int edge = 0;                ///< FreeCAD's EdgeN
  std::array<int, 2> nodes{};  ///< where the edge starts and ends, in its parameter's direction
  std::optional<EdgeUse> support = {};  ///< the face that stays beside the hole
  EdgeMatch match = EdgeMatch::Same;    ///< Twin: the support belongs to a coincident edge
  /// The way that keeps the hole to the left; nothing for an edge without faces.
  std::optional<Direction> heading = {};
  double length = 0.0;  ///< mm

  [[nodiscard]] int from(Direction d) const { return nodes[d == Direction::Forward ? 0 : 1]; }
  [[nodiscard]] int to(Direction d) const { return nodes[d == Direction::Forward ? 1 : 0]; }
};

/// One edge of a loop and the way the loop runs along it.
struct LoopEdge {
  int border = 0;  ///< position in BorderGraph::edges()
  Direction direction = Direction::Forward;
};

/// The edges that may border a hole and the nodes they meet at. Without picked faces these are the
/// free edges (one face) and the lone ones (none); with picked faces the edges between a picked and
/// a staying face. Ends that are separate vertices but lie within their tolerances, or within 1e-5
/// of the shape's size, are one node; coincident edges of an unsewn shape are one edge of two
/// faces.
class BorderGraph {
 public:
  [[nodiscard]] static BorderGraph build(const ShapeIndex& index, const Picks& picks);

  [[nodiscard]] const std::vector<BorderEdge>& edges() const { return edges_; }
  /// Position of an edge in edges(), -1 where it borders no hole.
  [[nodiscard]] int find(int edge) const;
  /// Positions of the edges that start or end at a node, ascending; a closed edge is listed twice.
  [[nodiscard]] const std::vector<int>& at(int node) const { return incident_[std::size_t(node)]; }
  [[nodiscard]] int nodeCount() const { return int(points_.size()); }
  [[nodiscard]] const Eigen::Vector3d& point(int node) const { return points_[std::size_t(node)]; }
  /// Numbers of faces that touch along coincident edges without sharing one, seam by seam.
  [[nodiscard]] const std::vector<std::vector<int>>& looseSeams() const { return looseSeams_; }
  /// Why a picked edge is not among the edges: EdgeNotFree, EdgeWithManyFaces, EdgeDegenerate or
  /// EdgeInfinite.
  [[nodiscard]] Error refusal(int edge) const;

 private:
  /// Lists the edges at every node.
  void connect();

  std::vector<BorderEdge> edges_;
  std::vector<std::vector<int>> looseSeams_;
  std::vector<int> position_;    ///< by edge number
  std::vector<Error> refusals_;  ///< by edge number, for those at no position
  std::vector<std::vector<int>> incident_;
  std::vector<Eigen::Vector3d> points_;
};

/// EdgeOutOfRange or EdgePickedTwice for the first number given that is none to work with.
[[nodiscard]] std::optional<Error> wrongEdge(const ShapeIndex& index,
                                             const std::vector<int>& edges);

/// The positions of edges in the graph; fails with the refusal of the lowest one that is not there.
[[nodiscard]] Result<std::set<int>> positionsOf(const BorderGraph& graph, std::vector<int> edges);

/// How much more of a walk's length, mm, has the hole to its left than to its right; edges without
/// a heading have no say.
[[nodiscard]] double headingBalance(const BorderGraph& graph, const std::vector<LoopEdge>& walk);

/// The walk the other way round.
void turnRound(std::vector<LoopEdge>& walk);

}  // namespace fairing::occt
