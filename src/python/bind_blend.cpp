// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include "core/blend/arms.h"
#include "core/blend/natural_blend.h"
#include "occt/blend_shape.h"
#include "occt/result_mode.h"
#include "python/bindings.h"
#include "python/conversions.h"
#include "python/guided_methods.h"
#include "text/words.h"

namespace py = pybind11;

namespace fairing::python {
namespace {

using occt::ShapeBlend;
using occt::ShapeIndex;

boundary::Leaving leaving(bool flipped) {
  return flipped ? boundary::Leaving::Backwards : boundary::Leaving::Onwards;
}

ShapeBlend blend(const ShapeIndex& shape,
                 std::vector<int> from,
                 std::vector<int> to,
                 const std::string& continuity,
                 const std::optional<Wishes>& wishes,
                 double fromReach,
                 double toReach,
                 std::optional<double> fromReachEnd,
                 std::optional<double> toReachEnd,
                 const std::string& fromDeparture,
                 const std::string& toDeparture,
                 bool fromFlip,
                 bool toFlip,
                 double fromSetback,
                 double toSetback,
                 std::vector<int> fromCurve,
                 std::vector<int> toCurve,
                 const std::string& match,
                 double alignment,
                 std::vector<std::pair<int, int>> pairs,
                 std::vector<int> ends,
                 std::vector<int> endFaces,
                 bool ring,
                 std::vector<int> cuts,
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
  const occt::BlendPicks picks{.from = std::move(from),
                               .to = std::move(to),
                               .continuity = continuityOf(continuity),
                               .edgeContinuity = continuitiesOf(wishes.value_or(Wishes{})),
                               .setback = {fromSetback, toSetback},
                               .setbackCurve = {std::move(fromCurve), std::move(toCurve)},
                               .match = choice(text::matchFrom, "match", match),
                               .alignment = alignment,
                               .pairs = std::move(pairs),
                               .ring = ring,
                               .cuts = std::move(cuts),
                               .ends = std::move(ends),
                               .endFaces = std::move(endFaces)};
  FillOptions fill = optionsOf(energy, inner, toleranceOf(tolerance, angle), degree, maxPoles);
  fill.guidance = guidanceOf(lambda, gamma, reference, guide);
  const BlendOptions options{std::move(fill),
                             {{fromReach, toReach}, {fromReachEnd, toReachEnd}},
                             {choice(text::departureFrom, "from_departure", fromDeparture),
                              choice(text::departureFrom, "to_departure", toDeparture)},
                             {leaving(fromFlip), leaving(toFlip)}};
  const occt::ResultMode mode = choice(occt::resultModeFrom, "result", result);
  const py::gil_scoped_release release;
  return finished(occt::blendShape(shape, picks, options, mode, progress), progress);
}

std::vector<std::vector<int>> chains(const ShapeIndex& shape, const std::vector<int>& edges) {
  return valueOf(occt::groupEdges(shape, edges));
}

py::tuple wholeChain(const ShapeIndex& shape,
                     std::vector<int> edges,
                     std::vector<int> others,
                     std::vector<int> ends,
                     std::vector<int> endFaces) {
  const auto chain = valueOf(occt::wholeChain(shape,
                                              {.from = std::move(edges),
                                               .to = std::move(others),
                                               .ends = std::move(ends),
                                               .endFaces = std::move(endFaces)}));
  return py::make_tuple(chain.edges, chain.closed);
}

ShapeBlend reaching(const ShapeBlend& blend,
                    double fromReach,
                    double toReach,
                    std::optional<double> fromReachEnd,
                    std::optional<double> toReachEnd) {
  const py::gil_scoped_release release;
  return valueOf(occt::reaching(blend, {{fromReach, toReach}, {fromReachEnd, toReachEnd}}));
}

py::list arms(const ShapeBlend& blend) {
  const auto triple = [](const Eigen::Vector3d& v) { return py::make_tuple(v.x(), v.y(), v.z()); };
  py::list result;
  if (blend.fill.layout != LayoutKind::Strip) return result;
  for (const Arm& arm : armsOf(blend.natural->result().patches))
    result.append(py::make_tuple(triple(arm.point), triple(arm.vector)));
  return result;
}

void bindBlendResult(py::module_& module) {
  py::class_<ShapeBlend, occt::ShapeFill> bound(
      module, "Blend", "A blend: its face, what was measured on it, and what it was made from.");
  bindGuidance(bound);
  bound
      .def("reaching",
           &reaching,
           py::arg("from_reach"),
           py::arg("to_reach"),
           py::arg("from_reach_end") = py::none(),
           py::arg("to_reach_end") = py::none(),
           "The same blend with other reaches, its face alone: one solve, for previews that follow "
           "a slider. By one thread at a time. Raises FairingError.")
      .def_property_readonly(
          "arms",
          &arms,
          "How the blend leaves either side in the middle of it at reach 1: pairs of a point and a "
          "vector, a third of the cross tangent over the whole blend. None of a junction.");
}

}  // namespace

void bindBlend(py::module_& module, py::class_<ShapeIndex>& shape) {
  bindBlendResult(module);
  shape
      .def("chains",
           &chains,
           py::arg("edges"),
           "Free edges grouped into chains that connect, each ascending, by their lowest edges. "
           "Raises FairingError where an edge is not free.")
      .def("whole_chain",
           &wholeChain,
           py::arg("edges"),
           py::arg("others") = std::vector<int>{},
           py::arg("ends") = std::vector<int>{},
           py::arg("end_faces") = std::vector<int>{},
           "The picked edges of one side of a blend in order, with those that continue them "
           "smoothly up to the other side's and the ends', and whether they close. Raises "
           "FairingError where "
           "they make no chain.")
      .def(
          "blend",
          &blend,
          py::arg("from_edges"),
          py::arg("to_edges"),
          py::arg("continuity") = "G1",
          py::arg("edge_continuity") = py::none(),
          py::arg("from_reach") = 1.0,
          py::arg("to_reach") = 1.0,
          py::arg("from_reach_end") = py::none(),
          py::arg("to_reach_end") = py::none(),
          py::arg("from_departure") = "free",
          py::arg("to_departure") = "free",
          py::arg("from_flip") = false,
          py::arg("to_flip") = false,
          py::arg("from_setback") = 0.0,
          py::arg("to_setback") = 0.0,
          py::arg("from_curve") = std::vector<int>{},
          py::arg("to_curve") = std::vector<int>{},
          py::arg("match") = std::string(text::word(boundary::MatchKind::Auto)),
          py::arg("alignment") = 0.0,
          py::arg("pairs") = std::vector<std::pair<int, int>>{},
          py::arg("ends") = std::vector<int>{},
          py::arg("end_faces") = std::vector<int>{},
          py::arg("ring") = false,
          py::arg("cuts") = std::vector<int>{},
          py::arg("energy") = std::string(text::word(FillOptions{}.energy)),
          py::arg("inner_continuity") = "G1",
          py::arg("lambda_") = 0.0,
          py::arg("gamma") = 0.0,
          py::arg("reference") = py::none(),
          py::arg("guide") = py::list(),
          py::arg("tolerance") = py::none(),
          py::arg("angle") = Tolerance{}.angle,
          py::arg("degree") = 0,
          py::arg("max_poles") = FillOptions{}.maxPoles,
          py::arg("result") = "patches",
          py::arg("progress") = py::none(),
          "Joins two chains of free edges by one strip, three and more closed ones by a junction, "
          "with "
          "ring open ones that come to a vertex, too; one edge of a smooth chain is enough. "
          "continuity is G0, G1 or G2, edge_continuity holds the edges that differ. from_reach and "
          "to_reach, above 0: how far the strip goes on before it turns away from either side, 1 = "
          "what the energy likes best; with from_reach_end or to_reach_end it changes linearly "
          "from the "
          "start of an open side to its end. from_departure and to_departure: free, perpendicular "
          "(to the edge) or iso (along the face's iso-curves). from_flip and to_flip: leave that "
          "side "
          "the other way, over its face. from_setback and to_setback, mm: start inside the faces "
          "at this "
          "distance from the edges; the faces are trimmed back to there. from_curve and to_curve: "
          "start at the curve that these edges make on the faces, or a little off them, instead. "
          "match is auto, length or corners: corners belong to corners "
          "where both sides have as many, points at equal shares of the lengths elsewhere. "
          "alignment, -0.5 to 0.5, turns closed sides against each other, by a share of the second "
          "one's length; pairs holds vertices of both sides that belong together. ends holds edges "
          "that join the ends of open sides, end_faces faces that the ends follow: along the edges "
          "of their border, or sliding on them. cuts holds edges from rim to rim that show where "
          "a junction is cut. inner_continuity, G1 or G2: how patches meet each other. lambda_, "
          "gamma, reference and guide are those of fill(). tolerance is in mm (None: a millionth "
          "of "
          "the diagonal of both chains), angle in degrees, degree 3 to 9 (0: chosen from the "
          "edges). The GIL is released while solving. Raises FairingError.");
}

}  // namespace fairing::python
