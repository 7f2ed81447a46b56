// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include "occt/edit_face.h"
#include "occt/shape_bytes.h"
#include "python/bindings.h"
#include "python/conversions.h"
#include "python/guided_methods.h"
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
               int spans) {
  EditOptions options;
  options.energy = choice(text::energyFrom, "energy", energy);
  if (keep) options.keep = choice(text::continuityFrom, "keep", *keep);
  options.guidance = guidanceOf(lambda, gamma, reference, guide);
  options.degree = degree;
  options.spans = spans;
  const py::gil_scoped_release release;
  return valueOf(occt::editFace(shape, face, options));
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
          "The new face as BREP text.")
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
      "Shapes a face anew: of least energy under guidance, its border kept. reference and guide "
      "are those of fill(); without them the face itself guides. keep is G0, G1 or G2 (None: G1, "
      "or G0 for the membrane). The GIL is released while solving. Raises FairingError.");
}

}  // namespace fairing::python
