// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/base/result.h"
#include "core/boundary/side_chain.h"

namespace fairing::boundary {

/// What a closed chain looks like from afar.
struct LoopShape {
  Eigen::Vector3d centre;  ///< mean of its points over its length
  Eigen::Vector3d area;    ///< vector area about the centre, mm^2: the loop runs round it
  Eigen::Vector3d into;    ///< mean of n x t, the way from its faces into the gap; length 0 to 1
  double radius = 0.0;     ///< of the circle that long, mm
};
[[nodiscard]] LoopShape shapeOf(const std::vector<BoundarySide>& sides);

/// Three or more closed chains that a junction is to join, as one loop: in the order in which its
/// cuts pass from one to the next, all of them run through the same way seen from the gap (chains
/// that do not are turned round). The first one stays the first. Fails with ChainsUnlike (one is
/// open), ChainTurns, and the codes of makeLoop().
[[nodiscard]] Result<BoundaryLoop> ringOfLoops(const std::vector<SideChain>& chains);

}  // namespace fairing::boundary
