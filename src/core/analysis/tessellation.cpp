// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/tessellation.h"

#include <Eigen/Geometry>

namespace fairing::analysis {

Mesh tessellate(const std::vector<spline::BsplineSurface>& patches,
                const std::vector<bool>& reversed,
                int divisions) {
  const int side = divisions + 1;
  const auto count = static_cast<Eigen::Index>(patches.size());
  Mesh mesh;
  mesh.points.resize(count * side * side, 3);
  mesh.normals.resize(count * side * side, 3);
  mesh.triangles.resize(count * 2 * divisions * divisions, 3);
  Eigen::Index vertex = 0, triangle = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto& [u, v, poles] = patches[p];
    const int first = static_cast<int>(vertex);
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j, ++vertex) {
        const auto jet = patches[p].jet(u.at(double(i) / divisions), v.at(double(j) / divisions));
        const Eigen::Vector3d normal = jet.normalVector().normalized() * (reversed[p] ? -1.0 : 1.0);
        mesh.points.row(vertex) = jet.point.cast<float>().transpose();
        mesh.normals.row(vertex) = normal.cast<float>().transpose();
      }
    for (int i = 0; i < divisions; ++i)
      for (int j = 0; j < divisions; ++j, triangle += 2) {
        const int a = first + i * side + j, b = a + side, c = b + 1, d = a + 1;
        if (reversed[p]) {
          mesh.triangles.row(triangle) << a, c, b;
          mesh.triangles.row(triangle + 1) << a, d, c;
        } else {
          mesh.triangles.row(triangle) << a, b, c;
          mesh.triangles.row(triangle + 1) << a, c, d;
        }
      }
  }
  return mesh;
}

}  // namespace fairing::analysis
