// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/base/result.h"
#include "occt/picks.h"
#include "occt/shape_index.h"

namespace fairing::cli {

/// The holes a command works on: the one that is picked, or every loop of free edges except outer
/// borders. Wishes for single edges go to the hole that has the edge. Fails with NothingPicked or
/// EdgeNotInLoop.
[[nodiscard]] Result<std::vector<occt::Picks>> targets(const occt::ShapeIndex& index,
                                                       const occt::Picks& picks);

}  // namespace fairing::cli
