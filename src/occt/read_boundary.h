// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/boundary/boundary_loop.h"
#include "occt/picks.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// The loop the picks mean (see traceLoop), each side with its curve, the face beside it and that
/// face's normals. An edge without a face is a G0 side unless its own wish says otherwise. Normals
/// are the faces'; where a face is oriented against most of its neighbours, its normal is turned,
/// so that the hole lies to the left of every side. An edge with a direction of its own takes that
/// in place of a face and is met G1 at most. Fails with the codes of traceLoop() and makeLoop(),
/// with EdgeNotInLoop, DirectionAlongEdge, EdgeOffPlane or LoopCrossesItself. The ribbons hold on
/// to the shape's geometry and must not be evaluated by two threads at once.
[[nodiscard]] Result<boundary::BoundaryLoop> readBoundary(const ShapeIndex& index,
                                                          const Picks& picks);

}  // namespace fairing::occt
