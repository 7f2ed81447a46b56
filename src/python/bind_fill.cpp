// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/fill_shape.h"
#include "occt/shape_bytes.h"
#include "python/bindings.h"
#include "python/error_to_python.h"
#include "python/fill_mesh.h"
#include "python/guided_methods.h"
#include "python/mesh_arrays.h"
#include "python/picture.h"
#include "text/report_json.h"
#include "text/report_text.h"

namespace py = pybind11;

namespace fairing::python {
namespace {

using occt::ShapeFill;

py::bytes brep(const ShapeFill& fill) {
  return valueOf(occt::bytesFromShape(valueOf(occt::shapeOf(fill))));
}

py::object report(const ShapeFill& fill) {
  return py::module_::import("json").attr("loads")(text::toJson(fill.fill).dump());
}

py::tuple mesh(const ShapeFill& fill, int divisions) {
  Mesh made;
  {
    const py::gil_scoped_release release;
    made = meshOf(fill.fill, divisions);
  }
  return arraysOf(made);
}

}  // namespace

void bindFill(py::module_& module) {
  py::class_<ShapeFill> bound(
      module, "Fill", "A filled hole or a blend: faces and what was measured on them.");
  bindGuidance(bound);
  bound.def("brep", &brep, "The result as BREP text: faces, shell or base, as asked for.")
      .def("mesh",
           &mesh,
           py::arg("divisions") = 32,
           "Triangles for drawing: points and unit normals (float32, n x 3), triangles (int32, m x "
           "3).")
      .def(
          "curvature_picture",
          [](const ShapeFill& fill, int divisions) {
            const py::gil_scoped_release release;
            return pictureOf(fill.fill, divisions);
          },
          py::arg("divisions") = 32,
          "Its curvature as a picture, each patch as fine as a grid of divisions x divisions.")
      .def_property_readonly(
          "report", &report, "Everything measured, as a dict: lengths in mm, angles in degrees.")
      .def_property_readonly(
          "verdict",
          [](const ShapeFill& fill) { return text::verdict(fill.fill.report); },
          "The report in one sentence.")
      .def_property_readonly(
          "table",
          [](const ShapeFill& fill) { return text::table(fill.fill.report); },
          "The report as a table: one line an edge, a seam, an inner constraint, a note.")
      .def_property_readonly(
          "composition",
          [](const ShapeFill& fill) { return text::composition(fill.fill); },
          "How the hole is spanned, in one sentence: layout, patches, control points.")
      .def_property_readonly(
          "within_tolerance",
          [](const ShapeFill& fill) { return fill.fill.report.withinTolerance; },
          "Whether every edge is met within the tolerances.");
}

}  // namespace fairing::python
