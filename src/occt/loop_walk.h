// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <set>
#include <vector>

#include "core/base/result.h"
#include "occt/border_graph.h"

namespace fairing::occt {

/// Follows the border of a hole from one edge until it is back there.
class LoopWalk {
 public:
  /// `picked`: positions in graph.edges() that win at a branch.
  LoopWalk(const ShapeIndex& index, const BorderGraph& graph, std::set<int> picked);

  /// An edge without a heading lies between two gaps: the shorter of both loops is meant.
  /// Fails with LoopNotClosed at a dead end, LoopBranches where the way on is not clear,
  /// LoopSelfTouching where a node is passed twice.
  [[nodiscard]] Result<std::vector<LoopEdge>> from(int border) const;

 private:
  [[nodiscard]] Result<std::vector<LoopEdge>> follow(const LoopEdge& start) const;
  [[nodiscard]] double lengthOf(const std::vector<LoopEdge>& loop) const;
  [[nodiscard]] std::vector<LoopEdge> leaving(int node, const std::set<int>& used, int start) const;
  [[nodiscard]] Result<LoopEdge> choose(const LoopEdge& arrived, std::vector<LoopEdge> ways) const;
  [[nodiscard]] Result<LoopEdge> chooseByAngle(const LoopEdge& arrived,
                                               const std::vector<LoopEdge>& ways) const;
  [[nodiscard]] Error deadEnd(const LoopEdge& arrived) const;
  [[nodiscard]] Eigen::Vector3d normalAt(int node, const std::vector<LoopEdge>& edges) const;

  const ShapeIndex& index_;
  const BorderGraph& graph_;
  std::set<int> picked_;
  std::vector<bool> dangling_;  ///< lone edges that lead nowhere
};

}  // namespace fairing::occt
