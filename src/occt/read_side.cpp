// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/read_side.h"

#include <algorithm>
#include <memory>

#include "occt/edge_curve.h"
#include "occt/edge_support.h"

namespace fairing::occt {

using boundary::BoundarySide;
using boundary::Ribbon;

namespace {

/// Points at which edge and face are compared.
constexpr int kDeviationSamples = 33;

/// An edge and the face beside it, evaluated together; shared by the ribbon's two functions.
struct Beside {
  EdgeCurve curve;
  std::optional<EdgeSupport> support;
};

Ribbon makeRibbon(const ShapeIndex& index, const BorderEdge& border, Direction direction) {
  const TopoDS_Edge& edge = index.edge(border.edge);
  const auto beside = std::make_shared<Beside>(EdgeCurve(edge, direction), std::nullopt);
  Ribbon ribbon;
  ribbon.curve = [beside](double t) { return beside->curve.at(t); };
  ribbon.polynomial = polynomialCurve(edge, direction);
  if (!ribbon.polynomial) ribbon.breaks = curveBreaks(edge, direction);
  if (border.support) {
    const bool turned = border.heading && *border.heading != direction;
    beside->support.emplace(index.face(border.support->face),
                            border.support->edge,
                            border.match,
                            turned ? NormalSense::Turned : NormalSense::AsFace);
    ribbon.support = [beside](double t) {
      return beside->support->at(beside->curve.parameter(t), beside->curve.point(t));
    };
  }
  return ribbon;
}

double supportDeviation(const Ribbon& ribbon) {
  double deviation = 0.0;
  for (int i = 0; ribbon.hasSupport() && i < kDeviationSamples; ++i) {
    const double t = double(i) / (kDeviationSamples - 1);
    const auto foot = ribbon.support(t);
    if (!foot.singular)
      deviation = std::max(deviation, (foot.point - ribbon.curve(t).point).norm());
  }
  return deviation;
}

Continuity wish(const Picks& picks, const BorderEdge& border) {
  const auto own = picks.edgeContinuity.find(border.edge);
  if (own != picks.edgeContinuity.end()) return own->second;
  if (picks.directions.contains(border.edge)) return std::min(picks.continuity, Continuity::G1);
  return border.support ? picks.continuity : Continuity::G0;
}

}  // namespace

BoundarySide readSide(const ShapeIndex& index,
                      const Picks& picks,
                      const BorderEdge& border,
                      Direction direction) {
  BoundarySide side;
  side.edge = border.edge;
  side.face = border.support ? border.support->face : 0;
  side.continuity = wish(picks, border);
  side.ribbon = makeRibbon(index, border, direction);
  side.supportDeviation = supportDeviation(side.ribbon);
  return side;
}

std::optional<Error> strayWish(const Picks& picks, const std::vector<BoundarySide>& sides) {
  const auto isStray = [&](int edge) {
    return std::none_of(
        sides.begin(), sides.end(), [&](const BoundarySide& side) { return side.edge == edge; });
  };
  for (const auto& [edge, wish] : picks.edgeContinuity) {
    if (isStray(edge)) return Error{.code = ErrorCode::EdgeNotInLoop, .edge = edge};
  }
  for (const auto& [edge, direction] : picks.directions) {
    if (isStray(edge)) return Error{.code = ErrorCode::EdgeNotInLoop, .edge = edge};
  }
  return std::nullopt;
}

}  // namespace fairing::occt
