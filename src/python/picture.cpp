// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/picture.h"

#include <algorithm>

#include "occt/curvature_picture.h"
#include "occt/make_faces.h"
#include "python/error_to_python.h"

namespace fairing::python {

analysis::CurvaturePicture pictureOf(const FillResult& fill, int divisions) {
  const int cells = std::max(divisions, 1);
  if (fill.trims.empty()) return analysis::curvaturePicture(fill.patches, fill.reversed, cells);
  return valueOf(
      occt::curvaturePicture(occt::ShapeIndex(valueOf(occt::makeFaces(fill))), {}, cells));
}

analysis::CurvaturePicture pictureOf(const occt::ShapeEdit& edit, int divisions) {
  const int cells = std::max(divisions, 1);
  if (edit.trimmed) return valueOf(occt::curvaturePicture(occt::ShapeIndex(edit.face), {}, cells));
  return analysis::curvaturePicture(
      {edit.edit.surface}, {edit.face.Orientation() == TopAbs_REVERSED}, cells);
}

}  // namespace fairing::python
