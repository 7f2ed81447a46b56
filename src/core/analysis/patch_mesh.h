// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/analysis/triangle_crossing.h"
#include "core/spline/bspline_surface.h"

namespace fairing::analysis {

/// Triangles on patches that meet edge to edge, about 2 `cells` in all: of one patch as square as
/// its domain allows, of several as many along u and v on each of them; at least eight. Points of
/// borders that coincide, within 1e-7 of the patches' extent, are one: neighbours share those of
/// their seam.
[[nodiscard]] TriangleMesh meshOf(const std::vector<spline::BsplineSurface>& patches,
                                  int cells = 1600);

}  // namespace fairing::analysis
