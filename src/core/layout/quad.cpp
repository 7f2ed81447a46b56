// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/quad.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/layout/side_curves.h"

namespace fairing::layout {
namespace {

using boundary::BoundaryLoop;
using spline::BsplineCurve;
using spline::KnotVector;

// Side k seen along the patch's u (k even) or v (k odd): North and West run against the loop.
DirectedSide directed(const BoundaryLoop& loop, std::size_t k) {
  return {&loop.sides[k], k >= 2};
}

BsplineCurve mapped(BsplineCurve curve, double width) {
  curve.knots = curve.knots.mapped(0.0, width);
  return curve;
}

// The ends of neighbouring edges differ by a CAD tolerance: the patch's corner lies half way.
void joinCorners(const BoundaryLoop& loop, std::array<std::optional<SideUse>, 4>& edges) {
  for (std::size_t k = 0; k < 4; ++k) {
    BsplineCurve& before = edges[k]->curve;
    BsplineCurve& after = edges[(k + 1) % 4]->curve;
    before.poles.bottomRows<1>() = loop.corners[k].point.transpose();
    after.poles.topRows<1>() = loop.corners[k].point.transpose();
  }
}

}  // namespace

QuadKnots chooseQuadKnots(const BoundaryLoop& loop, int degree, double fitTolerance, int maxPoles) {
  const auto along = [&](std::size_t k) {
    return chooseKnots({directed(loop, k), directed(loop, k + 2)}, degree, fitTolerance, maxPoles);
  };
  return {along(0), along(1)};
}

Result<PatchLayout> quadLayout(const BoundaryLoop& loop, const QuadKnots& knots) {
  if (loop.sides.size() != 4)
    return fail(
        {ErrorCode::WrongSideCount, 0, 0, std::nullopt, static_cast<double>(loop.sides.size())});
  const double lengthU = 0.5 * (loop.sides[0].length + loop.sides[2].length);
  const double lengthV = 0.5 * (loop.sides[1].length + loop.sides[3].length);
  const double width = std::sqrt(lengthU / lengthV);
  PatchLayout layout;
  layout.kind = LayoutKind::Quad;
  LayoutPatch patch;
  patch.u = knots.u.mapped(0.0, width);
  patch.v = knots.v.mapped(0.0, 1.0 / width);
  for (std::size_t k = 0; k < 4; ++k) {
    const bool alongU = k % 2 == 0;
    SideCurve side = curveOnKnots(directed(loop, k), alongU ? knots.u : knots.v);
    if (k >= 2) side.curve = spline::reversed(side.curve);
    patch.edges[k] = SideUse{
        static_cast<int>(k), 0.0, 1.0, mapped(std::move(side.curve), alongU ? width : 1.0 / width)};
    layout.curveDeviation = std::max(layout.curveDeviation, side.deviation);
  }
  joinCorners(loop, patch.edges);
  layout.pointCount = patch.u.poleCount() * patch.v.poleCount();
  patch.points.resize(static_cast<std::size_t>(layout.pointCount));
  std::iota(patch.points.begin(), patch.points.end(), 0);
  layout.patches.push_back(std::move(patch));
  return layout;
}

}  // namespace fairing::layout
