// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>

#include "core/analysis/continuity_report.h"
#include "core/base/result.h"
#include "core/boundary/boundary_loop.h"

namespace fairing::occt {

/// Measures any faces against the loop they are to fill. A gap is the distance from the boundary
/// curve to the nearest point of a face's surface within its trim (surface o pcurve); what the
/// faces' 3D edges claim is not looked at. Fails with ShapeEmpty where there is no face.
[[nodiscard]] Result<analysis::FillReport> measureShape(const boundary::BoundaryLoop& loop,
                                                        const TopoDS_Shape& patches,
                                                        const Tolerance& tolerance);

}  // namespace fairing::occt
