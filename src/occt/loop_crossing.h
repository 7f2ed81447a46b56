// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/base/error.h"
#include "core/boundary/boundary_loop.h"

namespace fairing::occt {

/// LoopCrossesItself where two places of a loop that are no neighbours coincide (within 1e-6 of its
/// diagonal). Places closer than 2 % of the diagonal along the loop are neighbours.
[[nodiscard]] std::optional<Error> findCrossing(const boundary::BoundaryLoop& loop);

}  // namespace fairing::occt
