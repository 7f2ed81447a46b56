// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/layout/patch_layout.h"

namespace fairing::constraint {

/// A seam's control points in its direction: on it, and the next row in either patch.
struct SeamRows {
  const layout::Seam* seam = nullptr;
  spline::KnotVector knots;  ///< over [0, 1]
  std::vector<int> on, first, second;
  double firstStep = 1.0, secondStep = 1.0;  ///< layout::crossStep() of either patch
};

[[nodiscard]] SeamRows seamRows(const layout::PatchLayout& layout, const layout::Seam& seam);

/// Row number `row` of the control points beside a seam, in its direction; 0 is the one on it.
[[nodiscard]] std::vector<int> rowInFirst(const layout::PatchLayout& layout,
                                          const layout::Seam& seam,
                                          int row);
[[nodiscard]] std::vector<int> rowInSecond(const layout::PatchLayout& layout,
                                           const layout::Seam& seam,
                                           int row);

}  // namespace fairing::constraint
