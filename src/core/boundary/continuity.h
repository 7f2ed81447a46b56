// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace fairing {

/// How a patch meets its neighbour across a side.
enum class Continuity {
  G0,  ///< the curve is shared
  G1,  ///< and the tangent plane
  G2,  ///< and the normal curvature across the side
};

}  // namespace fairing
