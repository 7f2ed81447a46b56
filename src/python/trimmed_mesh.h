// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "python/fill_mesh.h"

namespace fairing::python {

/// Triangles of trimmed patches, about as fine as a grid of `divisions` cells a side. Throws
/// Failure where the kernel finds a face invalid.
[[nodiscard]] Mesh trimmedMeshOf(const FillResult& fill, int divisions);

}  // namespace fairing::python
