// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/analysis/curvature_picture.h"
#include "core/span/fill_result.h"
#include "occt/edit_face.h"

namespace fairing::python {

/// The curvature of a fill: every patch on a grid of `divisions` by `divisions` cells, at least 1;
/// trimmed ones about as fine. Throws Failure where the kernel finds a face invalid.
[[nodiscard]] analysis::CurvaturePicture pictureOf(const FillResult& fill, int divisions);
[[nodiscard]] analysis::CurvaturePicture pictureOf(const occt::ShapeEdit& edit, int divisions);

}  // namespace fairing::python
