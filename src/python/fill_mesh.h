// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <cstdint>
#include <vector>

#include "core/fill/fill_hole.h"

namespace fairing::python {

/// Triangles for drawing. Rows of three: points (mm), unit normals on the side of the supports'
/// normals, point indices.
struct Mesh {
  std::vector<float> points, normals;
  std::vector<std::int32_t> triangles;
};

/// Every patch on a grid of `divisions` by `divisions` cells, at least 1; trimmed ones about as
/// fine (trimmed_mesh.h).
[[nodiscard]] Mesh meshOf(const FillResult& fill, int divisions);

/// The same of surfaces that are all of their faces.
[[nodiscard]] Mesh meshOf(const std::vector<spline::BsplineSurface>& surfaces,
                          const std::vector<bool>& reversed,
                          int divisions);

}  // namespace fairing::python
