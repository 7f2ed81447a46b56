// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>

#include "core/edit/edit_surface.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// An edited face.
struct ShapeEdit {
  TopoDS_Shape shape;  ///< the new face; its edges are those of the old one
  EditResult edit;
};

/// The face on an edited surface. Its trim stays: of a face that is trimmed out of its surface all
/// control points stay that have a say on the border, so it needs spans enough. A surface that is
/// no polynomial B-spline is converted, and a note says how closely. Fails with FaceOutOfRange,
/// ResultInvalid and the codes of editSurface().
[[nodiscard]] Result<ShapeEdit> editFace(const ShapeIndex& index,
                                         int face,
                                         const EditOptions& options);

}  // namespace fairing::occt
