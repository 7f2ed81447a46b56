// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace fairing {

/// What a fill has to meet. Relative members are multiplied by the loop's diagonal
/// (boundary_loop.h).
struct Tolerance {
  double gap = 0.0;  ///< largest distance of a boundary edge from the patches, mm; 0 = relativeGap
                     ///< * diagonal
  double relativeGap = 1e-6;  ///< used where gap is 0
  double angle = 0.02;        ///< largest angle between the normals along a side, degrees
  double cornerAngle = 0.05;  ///< the same within the 2 % of a side next to a corner, degrees

  [[nodiscard]] double gapFor(double diagonal) const {
    return gap > 0.0 ? gap : relativeGap * diagonal;
  }
};

}  // namespace fairing
