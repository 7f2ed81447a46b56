// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/edit_mesh.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <algorithm>

#include "python/trimmed_mesh.h"

namespace fairing::python {

Mesh meshOf(const occt::ShapeEdit& edit, int divisions) {
  const int cells = std::max(divisions, 1);
  const std::vector<bool> reversed{edit.face.Orientation() == TopAbs_REVERSED};
  const std::vector<spline::BsplineSurface> surfaces{edit.edit.surface};
  if (!edit.trimmed) return meshOf(surfaces, reversed, cells);
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(edit.face, false);  // the face keeps no triangles
  return trimmedMeshOf(copy, surfaces, reversed, edit.edit.report.diagonal, cells);
}

}  // namespace fairing::python
