// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/base/result.h"
#include "core/blend/blend_options.h"
#include "core/boundary/side_chain.h"

namespace fairing {

/// Why the chains cannot be left as the options ask: ReachVariesRound, DepartureNotTangent,
/// DepartureAlongEdge or EndAgainstSide.
[[nodiscard]] std::optional<Error> checkDepartures(const boundary::ChainPair& pair,
                                                   const BlendOptions& options);

}  // namespace fairing
