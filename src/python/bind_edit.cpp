// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include "occt/edit_face.h"
#include "occt/shape_bytes.h"
#include "python/bindings.h"
#include "python/conversions.h"
#include "python/edit_mesh.h"
#include "python/guided_methods.h"
#include "python/mesh_arrays.h"
#include "python/picture.h"
#include "text/edit_text.h"
#include "text/words.h"

namespace py = pybind11;

namespace fairing::python {
namespace {

using occt::ShapeEdit;
using occt::ShapeIndex;

ShapeEdit edit(const ShapeIndex& shape,
               int face,
               const std::string& energy,
               double lambda,
               double gamma,
               const std::optional<py::bytes>& reference,
               const py::object& guide,
               const std::optional<std::string>& keep,
               int degree,
               int spans,
               const std::string& result,
               Progress* progress) {
  EditOptions options;
  options.energy = choice(text::energyFrom, "energy", energy);
  if (keep) options.keep = choice(text::continuityFrom, "keep", *keep);
  options.guidance = guidanceOf(lambda, gamma, reference, guide);
  options.degree = degree;
  options.spans = spans;
  const occt::ResultMode mode = choice(occt::resultModeFrom, "result", result);
  const py::gil_scoped_release release;
  return finished(occt::editFace(shape, face, options, mode, progress), progress);
}

py::tuple mesh(const ShapeEdit& edit, int divisions) {
  Mesh made;
  {
    const py::gil_scoped_release release;
    made = meshOf(edit, divisions);
  }
  return arraysOf(made);
}

}  // namespace

void bindEdit(py::module_& module, py::class_<ShapeIndex>& shape) {
  py::class_<ShapeEdit> bound(module, "Edit", "An edited face and what was measured on it.");
  bindGuidance(bound);
  bound
      .def(
          "brep",
          [](const ShapeEdit& edit) {
            return py::bytes(valueOf(occt::bytesFromShape(edit.shape)));
          },
          "The result as BREP text: the new face, a shell of it, or the base, as asked for.")
      .def("mesh",
           &mesh,
           py::arg("divisions") = 32,
           "Triangles of the new face for drawing: points and unit normals (float32, n x 3), "
           "triangles (int32, m x 3).")
      .def(
          "curvature_picture",
          [](const ShapeEdit& edit, int divisions) {
            const py::gil_scoped_release release;
            return pictureOf(edit, divisions);
          },
          py::arg("divisions") = 32,
          "The curvature of the new face as a picture, as fine as a grid of divisions x divisions.")
      .def_property_readonly(
          "report",
          [](const ShapeEdit& edit) { return objectOf(text::toJson(edit.edit).dump()); },
          "Everything measured, as a dict: lengths in mm, angles in degrees.")
      .def_property_readonly(
          "verdict",
          [](const ShapeEdit& edit) { return text::verdict(edit.edit.report); },
          "The report in one sentence.")
      .def_property_readonly(
          "table",
          [](const ShapeEdit& edit) { return text::table(edit.edit.report); },
          "The report as a table: before and after, and a line a note.");
  shape.def(
      "edit",
      &edit,
      py::arg("face"),
      py::arg("energy") = std::string(text::word(EditOptions{}.energy)),
      py::arg("lambda_") = 0.0,
      py::arg("gamma") = 0.0,
      py::arg("reference") = py::none(),
      py::arg("guide") = py::list(),
      py::arg("keep") = py::none(),
      py::arg("degree") = 0,
      py::arg("spans") = 0,
      py::arg("result") = "patches",
      py::arg("progress") = py::none(),
      "Shapes a face anew: of least energy under guidance, its border kept. reference and guide "
      "are those of fill(); without them the face itself guides. keep is G0, G1 or G2 (None: G1, "
      "or G0 for the membrane). result is patches (the face alone), shell or base. The GIL is "
      "released while solving. Raises FairingError.");
}

}  // namespace fairing::python
