// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/fill_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "python/trimmed_mesh.h"

namespace fairing::python {
namespace {

void append(std::vector<float>& list, const Eigen::Vector3d& vector) {
  for (const double coordinate : vector) list.push_back(static_cast<float>(coordinate));
}

void addPatch(Mesh& mesh, const spline::BsplineSurface& patch, bool reversed, int divisions) {
  const auto first = static_cast<std::int32_t>(mesh.points.size() / 3);
  const double width = patch.u.last() - patch.u.first(), height = patch.v.last() - patch.v.first();
  for (int i = 0; i <= divisions; ++i) {
    for (int j = 0; j <= divisions; ++j) {
      const spline::SurfaceJet jet = patch.jet(patch.u.first() + width * i / divisions,
                                               patch.v.first() + height * j / divisions);
      append(mesh.points, jet.point);
      append(mesh.normals, (reversed ? -1.0 : 1.0) * jet.normalVector().normalized());
    }
  }
  const std::int32_t row = divisions + 1;
  for (std::int32_t i = 0; i < divisions; ++i) {
    for (std::int32_t j = 0; j < divisions; ++j) {
      const std::int32_t a = first + i * row + j, b = a + row, c = b + 1, d = a + 1;
      if (reversed) {
        mesh.triangles.insert(mesh.triangles.end(), {a, c, b, a, d, c});
      } else {
        mesh.triangles.insert(mesh.triangles.end(), {a, b, c, a, c, d});
      }
    }
  }
}

}  // namespace

Mesh meshOf(const FillResult& fill, int divisions) {
  if (!fill.trims.empty()) return trimmedMeshOf(fill, std::max(divisions, 1));
  Mesh mesh;
  for (std::size_t i = 0; i < fill.patches.size(); ++i) {
    addPatch(mesh, fill.patches[i], fill.reversed[i], std::max(divisions, 1));
  }
  return mesh;
}

}  // namespace fairing::python
