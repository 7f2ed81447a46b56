// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/blend/blend_chains.h"
#include "occt/fill_shape.h"
#include "occt/read_chains.h"

namespace fairing::occt {

/// The whole way: chains, strip or junction, faces, result. `loop` of what comes back holds all
/// chains. Fails with the codes of readChains(), readLoops(), blendChains(), blendLoops() and
/// joinResult().
[[nodiscard]] Result<ShapeFill> blendShape(const ShapeIndex& index,
                                           const BlendPicks& picks,
                                           const BlendOptions& options,
                                           ResultMode mode,
                                           Progress* progress = nullptr);

}  // namespace fairing::occt
