// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>

#include "occt/curvature_picture.h"
#include "occt/find_holes.h"
#include "occt/find_loop.h"
#include "occt/measure_shape.h"
#include "occt/read_boundary.h"
#include "occt/shape_bytes.h"
#include "python/bindings.h"
#include "python/conversions.h"
#include "text/report_json.h"
#include "text/words.h"

namespace py = pybind11;

namespace fairing::python {
namespace {

using occt::Picks;
using occt::ShapeIndex;

constexpr int kDrawnPoints = 65;  // of a boundary curve: smooth on a screen

ShapeIndex makeShape(const py::bytes& data) {
  const std::string bytes = data;
  const py::gil_scoped_release release;
  return ShapeIndex(valueOf(occt::shapeFromBytes(bytes)));
}

std::vector<std::vector<int>> holes(const ShapeIndex& shape, bool outerBorders) {
  std::vector<std::vector<int>> loops;
  for (occt::Hole& hole : occt::findHoles(shape)) {
    if (outerBorders || !hole.isOuterBorder) loops.push_back(std::move(hole.edges));
  }
  return loops;
}

std::vector<int> findLoop(const ShapeIndex& shape, std::vector<int> edges, std::vector<int> faces) {
  return valueOf(occt::findLoop(shape, {.edges = std::move(edges), .faces = std::move(faces)}));
}

py::array_t<double> drawnCurve(const boundary::Ribbon& ribbon) {
  py::array_t<double> points({kDrawnPoints, 3});
  auto rows = points.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < kDrawnPoints; ++i) {
    const Eigen::Vector3d point = ribbon.curve(double(i) / (kDrawnPoints - 1)).point;
    for (py::ssize_t k = 0; k < 3; ++k) rows(i, k) = point[k];
  }
  return points;
}

py::list boundarySides(const ShapeIndex& shape,
                       std::vector<int> edges,
                       std::vector<int> faces,
                       const std::string& continuity,
                       const Wishes& wishes,
                       const Directions& tangents,
                       const Directions& symmetry) {
  const auto loop = valueOf(occt::readBoundary(shape,
                                               {.edges = std::move(edges),
                                                .faces = std::move(faces),
                                                .continuity = continuityOf(continuity),
                                                .edgeContinuity = continuitiesOf(wishes),
                                                .directions = directionsOf(tangents, symmetry)}));
  py::list sides;
  for (const boundary::BoundarySide& side : loop.sides) {
    py::dict item;
    item["edge"] = side.edge;
    item["face"] = side.face;
    item["has_normal"] = side.ribbon.hasSupport();
    item["continuity"] = std::string(text::word(side.continuity));
    item["length"] = side.length;
    item["points"] = drawnCurve(side.ribbon);
    sides.append(item);
  }
  return sides;
}

py::object measure(const ShapeIndex& shape,
                   const ShapeIndex& patches,
                   std::vector<int> edges,
                   std::vector<int> faces,
                   const std::string& continuity,
                   const Wishes& wishes,
                   std::optional<double> tolerance,
                   double angle) {
  const Picks picks{.edges = std::move(edges),
                    .faces = std::move(faces),
                    .continuity = continuityOf(continuity),
                    .edgeContinuity = continuitiesOf(wishes)};
  FillOptions limits;
  limits.tolerance = toleranceOf(tolerance, angle);
  if (const auto error = validate(limits)) throw Failure(*error);
  std::string json;
  {
    const py::gil_scoped_release release;
    const auto loop = valueOf(occt::readBoundary(shape, picks));
    json =
        text::toJson(valueOf(occt::measureShape(loop, patches.shape(), limits.tolerance))).dump();
  }
  return objectOf(json);
}

}  // namespace

void bindShape(py::module_& module) {
  const auto noEdges = py::arg("edges") = std::vector<int>{};
  const auto noFaces = py::arg("faces") = std::vector<int>{};
  const auto continuity = py::arg("continuity") = "G1";
  const auto wishes = py::arg("edge_continuity") = Wishes{};
  const auto tolerance = py::arg("tolerance") = py::none();
  const auto angle = py::arg("angle") = Tolerance{}.angle;
  py::class_<ShapeIndex> shape(
      module, "Shape", "A shape read from BREP; edges and faces go by FreeCAD's numbers.");
  shape.def(py::init(&makeShape), py::arg("data"), "From BREP text, or FreeCAD's binary form.")
      .def_property_readonly("edge_count", &ShapeIndex::edgeCount)
      .def_property_readonly("face_count", &ShapeIndex::faceCount)
      .def("holes",
           &holes,
           py::arg("outer_borders") = false,
           "Loops of free edges; with outer_borders also the rims of open sheets.")
      .def("find_loop",
           &findLoop,
           noEdges,
           noFaces,
           "The edges of the hole that picked edges or faces belong to.")
      .def("boundary",
           &boundarySides,
           noEdges,
           noFaces,
           continuity,
           wishes,
           py::arg("tangents") = Directions{},
           py::arg("symmetry") = Directions{},
           "The sides of that hole in order: edge, face (0: none), whether there is a normal to "
           "meet, "
           "continuity, length and points (n x 3) to draw.")
      .def("measure",
           &measure,
           py::arg("patches"),
           noEdges,
           noFaces,
           continuity,
           wishes,
           tolerance,
           angle,
           "The report on any faces that are to fill that hole, as a dict.");
  shape.def(
      "curvature_picture",
      [](const ShapeIndex& index, const std::vector<int>& faces, int divisions) {
        const py::gil_scoped_release release;
        return valueOf(occt::curvaturePicture(index, faces, std::max(divisions, 1)));
      },
      noFaces,
      py::arg("divisions") = 64,
      "The curvature of faces (none: all) as a picture: no edge of a triangle is longer than the "
      "diagonal of them all over divisions. The GIL is released. Raises FairingError.");
  bindFilling(shape);
  bindBlend(module, shape);
  bindEdit(module, shape);
}

}  // namespace fairing::python
