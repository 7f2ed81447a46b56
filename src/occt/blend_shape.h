// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/blend/blend_chains.h"
#include "occt/fill_shape.h"
#include "occt/read_chains.h"

namespace fairing::occt {

/// The whole way: chains, strip or junction, faces, result. `loop` of what comes back holds all
/// chains; with a setback the base is the shape with its faces trimmed back, and edges bear the
/// numbers of those they were set back from. Fails with JunctionWish for a setback of a junction,
/// and the codes of readChains(), readLoops(), trimBack(), blendChains(), blendLoops() and
/// joinResult().
[[nodiscard]] Result<ShapeFill> blendShape(const ShapeIndex& index,
                                           const BlendPicks& picks,
                                           const BlendOptions& options,
                                           ResultMode mode,
                                           Progress* progress = nullptr);

}  // namespace fairing::occt
