// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/boundary/boundary_loop.h"
#include "occt/border_graph.h"
#include "occt/picks.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// An edge run through in a direction, with the face beside it and what is wished for it. The
/// face's normals are turned where the direction is against the border's own heading, so that what
/// is to be spanned lies to the left. Must not be evaluated by two threads at once.
[[nodiscard]] boundary::BoundarySide readSide(const ShapeIndex& index,
                                              const Picks& picks,
                                              const BorderEdge& border,
                                              Direction direction);

/// EdgeNotInLoop for a wish about an edge that is none of the sides, if there is one.
[[nodiscard]] std::optional<Error> strayWish(const Picks& picks,
                                             const std::vector<boundary::BoundarySide>& sides);

}  // namespace fairing::occt
