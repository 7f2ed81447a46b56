// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "core/edit/edit_surface.h"
#include "occt/result_mode.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// An edited face.
struct ShapeEdit {
  TopoDS_Face face;    ///< the new face; its edges are those of the old one
  TopoDS_Shape shape;  ///< what was asked for: that face, a shell of it, or the base with it
  EditResult edit;
  bool trimmed = false;  ///< whether the face is a part of its surface only
};

/// The face on an edited surface. Its trim stays: of a face that is trimmed out of its surface all
/// control points stay that have a say on the border, so it needs spans enough. A surface that is
/// no polynomial B-spline is converted, and a note says how closely. In the base the new face takes
/// the place of the old one. Fails with FaceOutOfRange, ResultInvalid and the codes of
/// editSurface().
[[nodiscard]] Result<ShapeEdit> editFace(const ShapeIndex& index,
                                         int face,
                                         const EditOptions& options,
                                         ResultMode mode = ResultMode::Patches);

}  // namespace fairing::occt
