// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/mesh_arrays.h"

#include <pybind11/numpy.h>

namespace py = pybind11;

namespace fairing::python {
namespace {

/// Copies a list of numbers into an array with three columns.
template <class Number>
py::array_t<Number> rowsOfThree(const std::vector<Number>& numbers) {
  const auto rows = static_cast<py::ssize_t>(numbers.size() / 3);
  return py::array_t<Number>({rows, py::ssize_t{3}}, numbers.data());
}

}  // namespace

py::tuple arraysOf(const Mesh& mesh) {
  return py::make_tuple(
      rowsOfThree(mesh.points), rowsOfThree(mesh.normals), rowsOfThree(mesh.triangles));
}

}  // namespace fairing::python
