// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/cut_loop.h"

#include "core/base/assert.h"
#include "core/boundary/edge_chain.h"

namespace fairing::boundary {
namespace {

// Cuts closer than this to an edge's end are at its end.
constexpr double kAtEnd = 1e-9;

std::vector<Stretch> stretchesBetween(const BoundaryLoop& loop, LoopPlace from, LoopPlace to) {
  std::vector<Stretch> result;
  const std::size_t n = loop.sides.size();
  std::size_t edge = from.side;
  double start = from.t;
  if (from.side == to.side && from.t < to.t) return {{from.side, from.t, to.t, 0.0, 1.0}};
  do {
    if (1.0 - start > kAtEnd) result.push_back({edge, start, 1.0, 0.0, 1.0});
    edge = (edge + 1) % n;
    start = 0.0;
  } while (edge != to.side);
  if (to.t > kAtEnd) result.push_back({to.side, 0.0, to.t, 0.0, 1.0});
  return result;
}

// One edge, or a stretch of it, affine in its own parameter.
BoundarySide stretchOfEdge(const BoundarySide& edge, const Stretch& s) {
  BoundarySide side = edge;
  if (s.from == 0.0 && s.to == 1.0) return side;
  const double from = s.from, width = s.to - s.from;
  side.ribbon.curve = [curve = edge.ribbon.curve, from, width](double t) {
    CurveSample sample = curve(from + t * width);
    sample.derivative *= width;
    return sample;
  };
  if (edge.ribbon.polynomial)
    side.ribbon.polynomial = spline::stretchOf(*edge.ribbon.polynomial, s.from, s.to);
  side.ribbon.breaks.clear();
  for (const CurveBreak& b : edge.ribbon.breaks)
    if (s.from < b.t && b.t < s.to)
      side.ribbon.breaks.push_back({(b.t - from) / width, b.continuity});
  if (edge.ribbon.hasSupport())
    side.ribbon.support = [support = edge.ribbon.support, from, width](double t) {
      return support(from + t * width);
    };
  side.stretches.clear();
  return side;
}

}  // namespace

Result<CutLoop> cutLoop(const BoundaryLoop& loop,
                        const std::vector<LoopPlace>& cuts,
                        int mostPoles) {
  FAIRING_ASSERT(cuts.size() >= 2);
  CutLoop cut;
  std::vector<BoundarySide> sides;
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    auto stretches = stretchesBetween(loop, cuts[k], cuts[(k + 1) % cuts.size()]);
    FAIRING_ASSERT(!stretches.empty());
    const auto& polynomial = loop.sides[stretches[0].edge].ribbon.polynomial;
    const bool keeps = polynomial && polynomial->knots.poleCount() <= mostPoles;
    if (stretches.size() == 1 && (keeps || !polynomial)) {
      sides.push_back(stretchOfEdge(loop.sides[stretches[0].edge], stretches[0]));
      cut.stretches.push_back(std::move(stretches));
      continue;
    }
    EdgeChain chain = chainEdges(loop, stretches);
    sides.push_back(std::move(chain.side));
    cut.stretches.push_back(std::move(chain.stretches));
  }
  auto made = makeLoop(std::move(sides));
  if (!made) return fail(made.error());
  cut.loop = std::move(*made);
  cut.loop.diagonal = loop.diagonal;
  return cut;
}

}  // namespace fairing::boundary
