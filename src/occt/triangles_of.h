// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Poly_Triangulation.hxx>
#include <array>
#include <vector>

namespace fairing::occt {

/// Corners of a mesh's triangles, numbered from 0.
[[nodiscard]] inline std::vector<std::array<int, 3>> trianglesOf(const Poly_Triangulation& mesh) {
  std::vector<std::array<int, 3>> triangles;
  for (int k = 1; k <= mesh.NbTriangles(); ++k) {
    int a = 0, b = 0, c = 0;
    mesh.Triangle(k).Get(a, b, c);
    triangles.push_back({a - 1, b - 1, c - 1});
  }
  return triangles;
}

}  // namespace fairing::occt
