// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <set>

#include "occt/fill_all.h"
#include "occt/result_mode.h"
#include "python/bindings.h"
#include "python/conversions.h"
#include "text/words.h"

namespace py = pybind11;

namespace fairing::python {
namespace {

using occt::ShapeIndex;

FillOptions fillOptionsOf(const std::string& layout,
                          const std::string& energy,
                          const std::string& inner,
                          energy::Guidance guidance,
                          const Tolerance& tolerance,
                          int degree,
                          int maxPoles) {
  const LayoutKind kind = choice(text::layoutFrom, "layout", layout);
  FillOptions options = optionsOf(energy, inner, tolerance, degree, maxPoles);
  options.layout = kind;
  options.guidance = std::move(guidance);
  return options;
}

occt::ShapeFill fill(const ShapeIndex& shape,
                     std::vector<int> edges,
                     std::vector<int> faces,
                     const std::string& continuity,
                     const Wishes& wishes,
                     const Directions& tangents,
                     const Directions& symmetry,
                     const std::vector<Through>& through,
                     const std::string& layout,
                     const std::string& energy,
                     const std::string& inner,
                     double lambda,
                     double gamma,
                     const std::optional<py::bytes>& reference,
                     const py::object& guide,
                     std::optional<double> tolerance,
                     double angle,
                     int degree,
                     int maxPoles,
                     const std::string& result,
                     Progress* progress) {
  const occt::Picks picks{.edges = std::move(edges),
                          .faces = std::move(faces),
                          .continuity = continuityOf(continuity),
                          .edgeContinuity = continuitiesOf(wishes),
                          .directions = directionsOf(tangents, symmetry)};
  FillOptions options = fillOptionsOf(layout,
                                      energy,
                                      inner,
                                      guidanceOf(lambda, gamma, reference, guide),
                                      toleranceOf(tolerance, angle),
                                      degree,
                                      maxPoles);
  options.through = throughOf(through);
  const occt::ResultMode mode = choice(occt::resultModeFrom, "result", result);
  const py::gil_scoped_release release;
  return finished(occt::fillShape(shape, picks, options, mode, progress), progress);
}

occt::AllFilled fillAll(const ShapeIndex& shape,
                        bool outerBorders,
                        std::set<int> skipped,
                        const std::string& continuity,
                        const Wishes& wishes,
                        const Directions& tangents,
                        const Directions& symmetry,
                        const std::string& layout,
                        const std::string& energy,
                        const std::string& inner,
                        double lambda,
                        double gamma,
                        const std::optional<py::bytes>& reference,
                        const py::object& guide,
                        std::optional<double> tolerance,
                        double angle,
                        int degree,
                        int maxPoles,
                        const std::string& result,
                        Progress* progress) {
  const occt::HoleChoice holes{.outerBorders = outerBorders,
                               .skipped = std::move(skipped),
                               .continuity = continuityOf(continuity),
                               .edgeContinuity = continuitiesOf(wishes),
                               .directions = directionsOf(tangents, symmetry)};
  const FillOptions options = fillOptionsOf(layout,
                                            energy,
                                            inner,
                                            guidanceOf(lambda, gamma, reference, guide),
                                            toleranceOf(tolerance, angle),
                                            degree,
                                            maxPoles);
  const occt::ResultMode mode = choice(occt::resultModeFrom, "result", result);
  const py::gil_scoped_release release;
  return valueOf(occt::fillAll(shape, holes, options, mode, progress));
}

}  // namespace

void bindFilling(py::class_<ShapeIndex>& shape) {
  const auto continuity = py::arg("continuity") = "G1";
  const auto wishes = py::arg("edge_continuity") = Wishes{};
  const auto tangents = py::arg("tangents") = Directions{};
  const auto symmetry = py::arg("symmetry") = Directions{};
  const auto layout = py::arg("layout") = "auto";
  const auto energy = py::arg("energy") = std::string(text::word(FillOptions{}.energy));
  const auto inner = py::arg("inner_continuity") = "G1";
  const auto lambda = py::arg("lambda_") = 0.0;
  const auto gamma = py::arg("gamma") = 0.0;
  const auto reference = py::arg("reference") = py::none();
  const auto guide = py::arg("guide") = py::list();
  const auto tolerance = py::arg("tolerance") = py::none();
  const auto angle = py::arg("angle") = Tolerance{}.angle;
  const auto degree = py::arg("degree") = 0;
  const auto maxPoles = py::arg("max_poles") = FillOptions{}.maxPoles;
  const auto result = py::arg("result") = "patches";
  const auto progress = py::arg("progress") = py::none();
  shape
      .def(
          "fill",
          &fill,
          py::arg("edges") = std::vector<int>{},
          py::arg("faces") = std::vector<int>{},
          continuity,
          wishes,
          tangents,
          symmetry,
          py::arg("through") = py::list(),
          layout,
          energy,
          inner,
          lambda,
          gamma,
          reference,
          guide,
          tolerance,
          angle,
          degree,
          maxPoles,
          result,
          progress,
          "Fills one hole. tangents and symmetry give edges a direction in their tangent plane, or "
          "the normal of a symmetry plane they lie in; through holds points (x, y, z) and BREP of "
          "edges and vertices to pass through. inner_continuity, G1 or G2, is how patches meet "
          "each "
          "other. tolerance is in mm (None: a millionth of the hole's diagonal), angle in degrees. "
          "reference is the BREP of faces that guide; guide a list of {point, normal, weight, "
          "radius}, or {normals: that list, field: {n, m, normals, weights, corners}}. The GIL is "
          "released while solving. Raises FairingError.")
      .def(
          "fill_all",
          &fillAll,
          py::arg("outer_borders") = false,
          py::arg("skipped") = std::set<int>{},
          continuity,
          wishes,
          tangents,
          symmetry,
          layout,
          energy,
          inner,
          lambda,
          gamma,
          reference,
          guide,
          tolerance,
          angle,
          degree,
          maxPoles,
          result,
          progress,
          "Fills every hole side by side, but for outer borders and for holes that have one of the "
          "skipped edges. A hole that fails leaves the others alone. Raises FairingError where "
          "none "
          "can be filled.");
}

}  // namespace fairing::python
