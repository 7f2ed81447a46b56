// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/conversions.h"

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "occt/inner_constraints.h"
#include "occt/reference.h"
#include "occt/shape_bytes.h"
#include "text/guide_json.h"
#include "text/words.h"

namespace py = pybind11;

namespace fairing::python {
Eigen::Vector3d vectorOf(const Triple& a) {
  return {a[0], a[1], a[2]};
}

TopoDS_Shape shapeOf(const py::bytes& data) {
  const std::string bytes = data;
  const py::gil_scoped_release release;
  return valueOf(occt::shapeFromBytes(bytes));
}

Continuity continuityOf(const std::string& word) {
  return choice(text::continuityFrom, "continuity", word);
}

std::map<int, Continuity> continuitiesOf(const Wishes& wishes) {
  std::map<int, Continuity> result;
  for (const auto& [edge, word] : wishes) result[edge] = continuityOf(word);
  return result;
}

std::map<int, occt::EdgeDirection> directionsOf(const Directions& tangents,
                                                const Directions& symmetry) {
  using Kind = occt::EdgeDirection::Kind;
  std::map<int, occt::EdgeDirection> result;
  for (const auto& [edge, d] : tangents) result[edge] = {vectorOf(d), Kind::Tangent};
  for (const auto& [edge, d] : symmetry) result[edge] = {vectorOf(d), Kind::Symmetry};
  return result;
}

Tolerance toleranceOf(std::optional<double> gap, double angle) {
  if (gap && !(*gap > 0.0)) throw Failure({.code = ErrorCode::ToleranceNotPositive, .value = *gap});
  Tolerance tolerance;
  tolerance.gap = gap.value_or(0.0);
  tolerance.angle = angle;
  return tolerance;
}

FillOptions optionsOf(const std::string& energy,
                      const std::string& inner,
                      const Tolerance& tolerance,
                      int degree,
                      int maxPoles) {
  FillOptions options;
  options.energy = choice(text::energyFrom, "energy", energy);
  options.inner = choice(text::continuityFrom, "inner_continuity", inner);
  options.tolerance = tolerance;
  options.degree = degree;
  options.maxPoles = maxPoles;
  return options;
}

energy::Guidance guidanceOf(double lambda,
                            double gamma,
                            const std::optional<py::bytes>& reference,
                            const py::object& guide) {
  energy::Guidance guidance;
  if (py::len(guide) > 0) {
    const py::object list = py::module_::import("builtins").attr("list");
    const auto text = py::module_::import("json")
                          .attr("dumps")(guide, py::arg("default") = list)
                          .cast<std::string>();
    const auto json = nlohmann::json::parse(text, nullptr, false);  // NaN is no JSON
    guidance = valueOf(text::guidanceFrom(json, "given"));
  }
  guidance.lambda = lambda;
  guidance.gamma = gamma;
  if (reference) guidance.reference = valueOf(occt::referenceOn(shapeOf(*reference)));
  return guidance;
}

std::vector<InnerConstraint> throughOf(const std::vector<Through>& through) {
  std::vector<InnerConstraint> result;
  for (const Through& item : through) {
    if (const auto* point = std::get_if<Triple>(&item)) {
      result.push_back(occt::throughPoint(vectorOf(*point)));
      continue;
    }
    const auto parts = valueOf(occt::throughShape(shapeOf(std::get<py::bytes>(item))));
    result.insert(result.end(), parts.begin(), parts.end());
  }
  return result;
}

py::object objectOf(const std::string& json) {
  return py::module_::import("json").attr("loads")(json);
}

}  // namespace fairing::python
