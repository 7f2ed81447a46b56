// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/blend/blend_chains.h"
#include "occt/fill_shape.h"
#include "occt/read_chains.h"

namespace fairing::occt {

/// The whole way: chains, strip, faces, result. `loop` of what comes back holds both chains. Fails
/// with the codes of readChains(), blendChains() and joinResult().
[[nodiscard]] Result<ShapeFill> blendShape(const ShapeIndex& index,
                                           const BlendPicks& picks,
                                           const BlendOptions& options,
                                           ResultMode mode,
                                           Progress* progress = nullptr);

}  // namespace fairing::occt
