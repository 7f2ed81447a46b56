// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/base/result.h"
#include "core/boundary/side_chain.h"
#include "core/spline/bspline_surface.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// The end of a strip that slides on a face: of a strip between the chains of `pair` whose end
/// there is free, `patches`, the border at the end of a chain (0: first, 1: second), projected onto
/// the face. Where the strip is tangent to a side it leaves the corner along the line that the
/// tangent planes of side and face share, where it is to have the side's curvature, with that. A
/// side met in position, without an edge of its own. Fails with EndLeavesFace and CurveNotFitted.
[[nodiscard]] Result<boundary::BoundarySide> slidingEnd(
    const ShapeIndex& index,
    int face,
    const boundary::ChainPair& pair,
    std::size_t chain,
    const std::vector<spline::BsplineSurface>& patches);

}  // namespace fairing::occt
