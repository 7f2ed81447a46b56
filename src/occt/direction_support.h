// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <map>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/boundary/boundary_loop.h"
#include "occt/picks.h"

namespace fairing::occt {

/// Gives sides that have a direction a support made of it: the plane through the edge's tangent and
/// the direction. Of its two senses the one is taken in which the neighbouring sides, or else the
/// whole loop, lie; where neither tells (the direction is square to both), the direction as given
/// points into the hole. Returns DirectionAlongEdge, or EdgeOffPlane for a symmetry plane that the
/// edge does not lie in.
[[nodiscard]] std::optional<Error> giveDirections(const std::map<int, EdgeDirection>& directions,
                                                  std::vector<boundary::BoundarySide>& sides);

}  // namespace fairing::occt
