// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/boundary/boundary_loop.h"

namespace fairing::analysis {

/// A place where a side is measured. Zones by arc length: the 2 % next to either end are "corner".
struct SidePlace {
  double t = 0.0;  ///< side parameter
  bool inCorner = false;
};

inline constexpr double kCornerZone = 0.02;  ///< share of a side's length next to either corner

/// Places evenly spread over the arc length, `inside` between the corner zones and `corner` in
/// either of them, ascending. None is an end of the side: a corner belongs to two sides and has the
/// normal of neither.
[[nodiscard]] std::vector<SidePlace> sidePlaces(const boundary::Ribbon& ribbon,
                                                int inside = 61,
                                                int corner = 8);

}  // namespace fairing::analysis
