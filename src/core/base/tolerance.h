// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace fairing {

/// Share of a side's length next to either corner in which Tolerance::cornerAngle counts.
inline constexpr double kCornerZone = 0.02;

/// What a fill has to meet. Relative members are multiplied by the loop's diagonal
/// (boundary_loop.h).
struct Tolerance {
  double gap = 0.0;  ///< largest distance of a boundary edge from the patches, mm; 0 = relativeGap
                     ///< * diagonal
  double relativeGap = 1e-6;  ///< used where gap is 0
  double angle = 0.02;        ///< largest angle between the normals along a side, degrees
  double cornerAngle = 0.05;  ///< the same within kCornerZone of a corner, degrees
  double curvature = 0.01;    ///< largest relative curvature mismatch along a G2 side, 0 to 1

  [[nodiscard]] double gapFor(double diagonal) const {
    return gap > 0.0 ? gap : relativeGap * diagonal;
  }
};

}  // namespace fairing
