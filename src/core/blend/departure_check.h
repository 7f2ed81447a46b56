// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <optional>

#include "core/base/result.h"
#include "core/blend/reach.h"
#include "core/boundary/departure.h"
#include "core/boundary/side_chain.h"

namespace fairing {

/// What is asked of how a strip leaves either side.
struct Departures {
  std::array<boundary::Departure, 2> departure{};
  std::array<boundary::Leaving, 2> leaving{};
  Reach reach;
};

/// Why the chains cannot be left so: ReachVariesRound, DepartureNotTangent or DepartureAlongEdge.
[[nodiscard]] std::optional<Error> checkDepartures(const boundary::ChainPair& pair,
                                                   const Departures& asked);

}  // namespace fairing
