// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>

#include "python/fill_mesh.h"

namespace fairing::python {

/// Triangles of trimmed patches, about as fine as a grid of `divisions` cells a side. Throws
/// Failure where the kernel finds a face invalid.
[[nodiscard]] Mesh trimmedMeshOf(const FillResult& fill, int divisions);

/// The same of any faces, on surfaces with their parameters; lengths are seen against the diagonal,
/// mm.
[[nodiscard]] Mesh trimmedMeshOf(const TopoDS_Shape& faces,
                                 const std::vector<spline::BsplineSurface>& surfaces,
                                 const std::vector<bool>& reversed,
                                 double diagonal,
                                 int divisions);

}  // namespace fairing::python
