// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/base/result.h"
#include "occt/picks.h"
#include "occt/shape_index.h"

namespace fairing::cli {

/// The holes a command works on: the one that is picked, or every loop of free edges; outer borders
/// only where asked for. Fails with the codes of chooseHoles().
[[nodiscard]] Result<std::vector<occt::Picks>> targets(const occt::ShapeIndex& index,
                                                       const occt::Picks& picks,
                                                       bool outerBorders = false);

}  // namespace fairing::cli
