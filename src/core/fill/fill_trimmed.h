// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/fill/fill_hole.h"

namespace fairing {

/// Fills a loop with one surface, a height over a plane, trimmed by the loop: the way for loops
/// that no layout of quads suits, and for who prefers one face. Sides and inner constraints are met
/// in the sense of least squares and the chosen energy of what lies inside the loop is least among
/// such surfaces; knots are refined where a side is out of tolerance. Fails with the codes of
/// validate(), LayoutUnfit (no plane sees the loop without crossings), InnerConstraintOff,
/// SystemSingular, NotFinite or Cancelled. docs/algorithms/trimmed_fill.md
[[nodiscard]] Result<FillResult> fillTrimmed(const boundary::BoundaryLoop& loop,
                                             const FillOptions& options,
                                             Progress* progress = nullptr);

}  // namespace fairing
