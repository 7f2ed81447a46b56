// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include "occt/fill_all.h"
#include "occt/shape_bytes.h"
#include "python/bindings.h"
#include "python/error_to_python.h"
#include "text/error_text.h"
#include "text/report_text.h"

namespace py = pybind11;

namespace fairing::python {
namespace {

using occt::AllFilled;
using occt::HoleFill;

const occt::ShapeFill* fillOf(const HoleFill& hole) {
  return hole.fill ? &*hole.fill : nullptr;
}

std::string errorOf(const HoleFill& hole) {
  return hole.fill ? std::string() : text::sentence(hole.fill.error());
}

py::list holesOf(const py::object& all) {
  py::list holes;
  for (const HoleFill& hole : all.cast<const AllFilled&>().holes) {
    holes.append(py::cast(hole, py::return_value_policy::reference_internal, all));
  }
  return holes;
}

std::string tableOf(const AllFilled& all) {
  std::vector<text::HoleLine> lines;
  for (const HoleFill& hole : all.holes) {
    lines.push_back({hole.edges,
                     hole.fill ? &hole.fill->fill : nullptr,
                     hole.fill ? nullptr : &hole.fill.error()});
  }
  return text::table(lines);
}

}  // namespace

void bindFillAll(py::module_& module) {
  py::class_<HoleFill>(module, "HoleFill", "What became of one of several holes.")
      .def_readonly("edges", &HoleFill::edges, "The edges round the hole, in order.")
      .def_property_readonly("fill",
                             &fillOf,
                             py::return_value_policy::reference_internal,
                             "The Fill, or None where there is none.")
      .def_property_readonly("error", &errorOf, "Why there is none, in one sentence; else empty.");
  py::class_<AllFilled>(module, "FillAll", "The holes of a shape, filled.")
      .def(
          "brep",
          [](const AllFilled& all) -> py::bytes {
            return valueOf(occt::bytesFromShape(all.shape));
          },
          "The result as BREP text: faces, shells or base, as asked for.")
      .def_property_readonly("holes", &holesOf, "One HoleFill a hole.")
      .def_property_readonly("table", &tableOf, "The holes as a table, one line a hole.")
      .def_property_readonly("within_tolerance",
                             &AllFilled::withinTolerance,
                             "Whether every hole is filled within the tolerances.");
}

}  // namespace fairing::python
