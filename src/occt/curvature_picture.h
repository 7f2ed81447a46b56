// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/analysis/curvature_picture.h"
#include "core/base/result.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// Faces of any kind as a picture of their curvature, against their own normals: the kernel's
/// triangles in the parameters, refined until their edges are no longer than the diagonal of all
/// faces over `divisions` and turn no normal by more than a few degrees; values by the surfaces'
/// own derivatives. Faces that hold a mesh and no surface are left out. Fails with
/// FaceOutOfRange.
[[nodiscard]] Result<analysis::CurvaturePicture> curvaturePicture(
    const ShapeIndex& index,
    const std::vector<int>& faces,  ///< FreeCAD's numbers; none: all
    int divisions);

}  // namespace fairing::occt
