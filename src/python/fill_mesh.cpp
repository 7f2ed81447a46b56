// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/fill_mesh.h"

#include <algorithm>

#include "core/analysis/tessellation.h"
#include "python/trimmed_mesh.h"

namespace fairing::python {
Mesh meshOf(const FillResult& fill, int divisions) {
  if (!fill.trims.empty()) return trimmedMeshOf(fill, std::max(divisions, 1));
  return meshOf(fill.patches, fill.reversed, std::max(divisions, 1));
}

Mesh meshOf(const std::vector<spline::BsplineSurface>& surfaces,
            const std::vector<bool>& reversed,
            int divisions) {
  const auto grid = analysis::tessellate(surfaces, reversed, divisions);
  const auto listOf = [](const auto& matrix) {
    return std::vector(matrix.data(), matrix.data() + matrix.size());
  };
  return {listOf(grid.points), listOf(grid.normals), listOf(grid.triangles)};
}

}  // namespace fairing::python
