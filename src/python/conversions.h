// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <pybind11/pybind11.h>
#include <TopoDS_Shape.hxx>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/progress.h"
#include "core/span/fill_options.h"
#include "occt/picks.h"
#include "python/error_to_python.h"

/// Python's words, tuples and dicts as the types of the core. Whatever makes no sense throws a
/// Failure.
namespace fairing::python {

using Wishes = std::map<int, std::string>;
using Triple = std::array<double, 3>;
using Directions = std::map<int, Triple>;
/// A point, or BREP whose edges and lone vertices are meant.
using Through = std::variant<pybind11::bytes, Triple>;

/// The choice a word stands for, or UnknownChoice.
template <class Parse>
auto choice(Parse parse, const char* option, const std::string& word) {
  const auto found = parse(word);
  if (!found)
    throw Failure({.code = ErrorCode::UnknownChoice, .detail = "\"" + word + "\" for " + option});
  return *found;
}

/// A result that is there has taken all of its time. Throws what the result failed with.
template <class T>
T finished(Result<T> made, Progress* progress) {
  if (made && progress != nullptr) progress->setFraction(1.0);
  return valueOf(std::move(made));
}

[[nodiscard]] Continuity continuityOf(const std::string& word);
[[nodiscard]] std::map<int, Continuity> continuitiesOf(const Wishes& wishes);
[[nodiscard]] std::map<int, occt::EdgeDirection> directionsOf(const Directions& tangents,
                                                              const Directions& symmetry);

/// A gap tolerance that is given has to be positive; the core reads 0 as "a millionth of the
/// diagonal".
[[nodiscard]] Tolerance toleranceOf(std::optional<double> gap, double angle);

/// What fills and blends have in common of their options.
[[nodiscard]] FillOptions optionsOf(const std::string& energy,
                                    const std::string& inner,
                                    const Tolerance& tolerance,
                                    int degree,
                                    int maxPoles);

[[nodiscard]] Eigen::Vector3d vectorOf(const Triple& a);
/// From BREP. Raises FairingError.
[[nodiscard]] TopoDS_Shape shapeOf(const pybind11::bytes& data);

/// `guide`: a list of handles, or a dict with handles and a field (text/guide_json.h); empty =
/// none; points are any sequences of three. `reference`: BREP of the faces that guide.
[[nodiscard]] energy::Guidance guidanceOf(double lambda,
                                          double gamma,
                                          const std::optional<pybind11::bytes>& reference,
                                          const pybind11::object& guide);

[[nodiscard]] std::vector<InnerConstraint> throughOf(const std::vector<Through>& through);

/// Words, a tuple of numbers and JSON text as Python objects.
[[nodiscard]] pybind11::object objectOf(const std::string& json);

}  // namespace fairing::python
