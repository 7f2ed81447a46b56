// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/boundary/boundary_loop.h"
#include "core/spline/bspline_surface.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// What is wrong with a blend as a surface in its place: where it has creases, folds, cuts through
/// itself or through the faces it joins, and where these overlap. `sides`: all
/// it meets, `chains`: those of them that it joins. By triangles whose distance from
/// the surfaces is below 0.2 % of the blend's diagonal; what happens within 1 % of the edges it
/// meets is not seen.
[[nodiscard]] std::vector<analysis::Note> blendNotes(
    const ShapeIndex& index,
    const boundary::BoundaryLoop& sides,
    const std::vector<boundary::SideRange>& chains,
    const std::vector<spline::BsplineSurface>& patches);

}  // namespace fairing::occt
