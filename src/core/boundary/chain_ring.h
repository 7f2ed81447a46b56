// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/boundary/cut_loop.h"

namespace fairing::boundary {

/// A cut of a junction that is set, between two of its chains.
struct RingCut {
  LoopPlace first, second;
  int edge = 0;  ///< FreeCAD's EdgeN that shows it, for messages
};

/// Three chains or more that a junction is to join. Closed ones: cuts pass from each to the next.
/// Open ones: there is a gap from the end of each to the start of the next one.
struct ChainRing {
  BoundaryLoop sides;
  std::vector<RingCut> cuts = {};  ///< of closed chains, in any order; the others are found
};

}  // namespace fairing::boundary
