// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <pybind11/pytypes.h>

#include "python/fill_mesh.h"

namespace fairing::python {

/// Points and normals (float32, n x 3) and triangles (int32, m x 3) as numpy arrays.
[[nodiscard]] pybind11::tuple arraysOf(const Mesh& mesh);

}  // namespace fairing::python
