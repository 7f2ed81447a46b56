// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <memory>

#include "core/blend/blend_chains.h"
#include "occt/fill_shape.h"
#include "occt/read_chains.h"

namespace fairing::occt {

/// A blend of a shape; `loop` holds all chains.
struct ShapeBlend : ShapeFill {
  std::shared_ptr<const NaturalBlend> natural = nullptr;  ///< what reaching() starts from
  Reach reach = {};
};

/// The whole way: chains, strip or junction, faces, result. With a setback the base is the shape
/// with its faces trimmed back, and edges bear the numbers of those they were set back from. Fails
/// with JunctionWish for what a junction has not (setback, matching, pairs, ends), CutUnfit,
/// SetbackPairs, and the codes of readBlend(), readEnds(), slidingEnd(), trimBack(), blendChains(),
/// blendRing() and joinResult().
[[nodiscard]] Result<ShapeBlend> blendShape(const ShapeIndex& index,
                                            const BlendPicks& picks,
                                            const BlendOptions& options,
                                            ResultMode mode,
                                            Progress* progress = nullptr);

/// The same blend with other reaches, as a preview. Of a strip: one solve, so that it follows a
/// slider. By one thread at a time. Fails with ReachNotPositive and the codes of
/// blendChains() and blendRing().
[[nodiscard]] Result<ShapeBlend> reaching(const ShapeBlend& blend, const Reach& reach);

}  // namespace fairing::occt
