// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>

#include "occt/fill_shape.h"
#include "occt/find_holes.h"
#include "occt/find_loop.h"
#include "occt/measure_shape.h"
#include "occt/read_boundary.h"
#include "occt/reference.h"
#include "occt/result_mode.h"
#include "occt/shape_bytes.h"
#include "python/bindings.h"
#include "python/error_to_python.h"
#include "text/report_json.h"
#include "text/words.h"

namespace py = pybind11;

namespace fairing::python {
namespace {

using occt::Picks;
using occt::ShapeFill;
using occt::ShapeIndex;
using Wishes = std::map<int, std::string>;

constexpr int kDrawnPoints = 65;  // of a boundary curve: smooth on a screen

/// The choice a word stands for, or UnknownChoice.
template <class Parse>
auto choice(Parse parse, const char* option, const std::string& word) {
  const auto found = parse(word);
  if (!found)
    throw Failure({.code = ErrorCode::UnknownChoice, .detail = "\"" + word + "\" for " + option});
  return *found;
}

Picks picksOf(std::vector<int> edges,
              std::vector<int> faces,
              const std::string& continuity,
              const Wishes& wishes) {
  Picks picks;
  picks.edges = std::move(edges);
  picks.faces = std::move(faces);
  picks.continuity = choice(text::continuityFrom, "continuity", continuity);
  for (const auto& [edge, word] : wishes) {
    picks.edgeContinuity[edge] = choice(text::continuityFrom, "continuity", word);
  }
  return picks;
}

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
  return valueOf(occt::findLoop(shape, picksOf(std::move(edges), std::move(faces), "G1", {})));
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
                       const Wishes& wishes) {
  const auto loop = valueOf(
      occt::readBoundary(shape, picksOf(std::move(edges), std::move(faces), continuity, wishes)));
  py::list sides;
  for (const boundary::BoundarySide& side : loop.sides) {
    py::dict item;
    item["edge"] = side.edge;
    item["face"] = side.face;
    item["continuity"] = std::string(text::word(side.continuity));
    item["length"] = side.length;
    item["points"] = drawnCurve(side.ribbon);
    sides.append(item);
  }
  return sides;
}

/// A gap tolerance that is given has to be positive; the core reads 0 as "a millionth of the
/// diagonal".
double gapTolerance(std::optional<double> given) {
  if (given && !(*given > 0.0))
    throw Failure({.code = ErrorCode::ToleranceNotPositive, .value = *given});
  return given.value_or(0.0);
}

Eigen::Vector3d vectorOf(const py::handle& value) {
  const auto list = value.cast<std::array<double, 3>>();
  return {list[0], list[1], list[2]};
}

/// {"point": (x, y, z), "normal": (x, y, z), "weight": w, "radius": mm}; weight may be left out.
energy::NormalHandle handleOf(const py::dict& guide) {
  return {.point = vectorOf(guide["point"]),
          .normal = vectorOf(guide["normal"]),
          .weight = guide.contains("weight") ? guide["weight"].cast<double>() : 1.0,
          .radius = guide["radius"].cast<double>()};
}

energy::Guidance guidanceOf(double lambda,
                            double gamma,
                            const std::optional<py::bytes>& reference,
                            const std::vector<py::dict>& guide) {
  energy::Guidance guidance;
  guidance.lambda = lambda;
  guidance.gamma = gamma;
  for (const py::dict& item : guide) guidance.handles.push_back(handleOf(item));
  if (reference) {
    const std::string bytes = *reference;
    const py::gil_scoped_release release;
    guidance.reference = valueOf(occt::referenceOn(valueOf(occt::shapeFromBytes(bytes))));
  }
  return guidance;
}

ShapeFill fill(const ShapeIndex& shape,
               std::vector<int> edges,
               std::vector<int> faces,
               const std::string& continuity,
               const Wishes& wishes,
               const std::string& layout,
               const std::string& energy,
               double lambda,
               double gamma,
               const std::optional<py::bytes>& reference,
               const std::vector<py::dict>& guide,
               std::optional<double> tolerance,
               double angle,
               int degree,
               int maxPoles,
               const std::string& result,
               Progress* progress) {
  const Picks picks = picksOf(std::move(edges), std::move(faces), continuity, wishes);
  FillOptions options;
  options.layout = choice(text::layoutFrom, "layout", layout);
  options.energy = choice(text::energyFrom, "energy", energy);
  options.guidance = guidanceOf(lambda, gamma, reference, guide);
  options.tolerance.gap = gapTolerance(tolerance);
  options.tolerance.angle = angle;
  options.degree = degree;
  options.maxPoles = maxPoles;
  const occt::ResultMode mode = choice(occt::resultModeFrom, "result", result);
  const py::gil_scoped_release release;
  auto made = occt::fillShape(shape, picks, options, mode, progress);
  if (made && progress != nullptr) progress->setFraction(1.0);
  return valueOf(std::move(made));
}

py::object measure(const ShapeIndex& shape,
                   const ShapeIndex& patches,
                   std::vector<int> edges,
                   std::vector<int> faces,
                   const std::string& continuity,
                   const Wishes& wishes,
                   std::optional<double> tolerance,
                   double angle) {
  const Picks picks = picksOf(std::move(edges), std::move(faces), continuity, wishes);
  FillOptions limits;
  limits.tolerance.gap = gapTolerance(tolerance);
  limits.tolerance.angle = angle;
  if (const auto error = validate(limits)) throw Failure(*error);
  std::string json;
  {
    const py::gil_scoped_release release;
    const auto loop = valueOf(occt::readBoundary(shape, picks));
    json =
        text::toJson(valueOf(occt::measureShape(loop, patches.shape(), limits.tolerance))).dump();
  }
  return py::module_::import("json").attr("loads")(json);
}

}  // namespace

void bindShape(py::module_& module) {
  const auto noEdges = py::arg("edges") = std::vector<int>{};
  const auto noFaces = py::arg("faces") = std::vector<int>{};
  const auto continuity = py::arg("continuity") = "G1";
  const auto wishes = py::arg("edge_continuity") = Wishes{};
  const auto tolerance = py::arg("tolerance") = py::none();
  const auto angle = py::arg("angle") = Tolerance{}.angle;
  py::class_<ShapeIndex>(
      module, "Shape", "A shape read from BREP; edges and faces go by FreeCAD's numbers.")
      .def(py::init(&makeShape), py::arg("data"), "From BREP text, or FreeCAD's binary form.")
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
           "The sides of that hole in order: edge, face (0: none), continuity, length and points "
           "(n x 3) to draw.")
      .def("fill",
           &fill,
           noEdges,
           noFaces,
           continuity,
           wishes,
           py::arg("layout") = "auto",
           py::arg("energy") = "thin-plate",
           py::arg("lambda_") = 0.0,
           py::arg("gamma") = 0.0,
           py::arg("reference") = py::none(),
           py::arg("guide") = py::list(),
           tolerance,
           angle,
           py::arg("degree") = 0,
           py::arg("max_poles") = FillOptions{}.maxPoles,
           py::arg("result") = "patches",
           py::arg("progress") = py::none(),
           "Fills one hole. tolerance is in mm (None: a millionth of the hole's diagonal), angle "
           "in degrees. reference is "
           "the BREP of faces that guide; guide a list of {point, normal, weight, radius}. The GIL "
           "is released while "
           "solving. Raises FairingError.")
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
}

}  // namespace fairing::python
