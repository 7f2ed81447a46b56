// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <string>

#include "core/analysis/curvature_picture.h"
#include "python/bindings.h"
#include "python/conversions.h"
#include "text/words.h"

namespace py = pybind11;

namespace fairing::python {
namespace {

using analysis::CurvaturePicture;

py::dict placeAt(const CurvaturePicture& picture, int triangle, double a, double b) {
  if (triangle < 0 || triangle >= picture.triangleCount())
    throw py::index_error("There is no triangle " + std::to_string(triangle) + ".");
  const analysis::CurvaturePlace place = picture.at(triangle, a, b);
  py::dict values;
  for (int k = 0; k < analysis::kCurvatureQuantities; ++k)
    values[py::str(std::string(text::word(static_cast<analysis::CurvatureQuantity>(k))))] =
        place.values[k];
  py::dict item;
  item["face"] = place.number;
  item["point"] = Triple{place.point.x(), place.point.y(), place.point.z()};
  item["normal"] = Triple{place.normal.x(), place.normal.y(), place.normal.z()};
  item["values"] = values;
  return item;
}

}  // namespace

void bindPicture(py::module_& module) {
  py::class_<CurvaturePicture>(
      module,
      "CurvaturePicture",
      "Surfaces as triangles with the curvature at every vertex. Curvatures "
      "are positive where a surface bends towards its normal.")
      .def(
          "mesh",
          [](const CurvaturePicture& picture) {
            const analysis::Mesh mesh = picture.mesh();
            return py::make_tuple(mesh.points, mesh.normals, mesh.triangles);
          },
          "Points and unit normals (float32, n x 3) and triangles (int32, m x 3).")
      .def("values",
           &CurvaturePicture::values,
           "A row a vertex (n x 5): mean curvature H (1/mm), Gaussian curvature K (1/mm^2), "
           "principal curvatures k1 >= k2 (1/mm), |grad H| (1/mm^2). NaN where there is none.")
      .def(
          "range",
          [](const CurvaturePicture& picture, const std::string& quantity) {
            return picture.range(choice(text::quantityFrom, "quantity", quantity));
          },
          py::arg("quantity"),
          "What nearly all of the picture lies within, symmetric about 0 but for mean-gradient. "
          "quantity is mean, gauss, k1, k2 or mean-gradient. Raises FairingError.")
      .def("at",
           &placeAt,
           py::arg("triangle"),
           py::arg("a"),
           py::arg("b"),
           "The surface's own curvature at (1 - a - b) of a triangle's first corner, a of its "
           "second and b of its third: face (or patch, from 1 on), point, normal, and values by "
           "quantity.");
}

}  // namespace fairing::python
