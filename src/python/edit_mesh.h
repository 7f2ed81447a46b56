// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "occt/edit_face.h"
#include "python/fill_mesh.h"

namespace fairing::python {

/// An edited face on a grid of `divisions` by `divisions` cells, at least 1; a trimmed one about as
/// fine. Throws Failure where the kernel finds the face invalid.
[[nodiscard]] Mesh meshOf(const occt::ShapeEdit& edit, int divisions);

}  // namespace fairing::python
