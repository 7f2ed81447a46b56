// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/cut_loop.h"

#include <algorithm>
#include <memory>

#include "core/base/assert.h"
#include "core/boundary/arc_length.h"

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

// Several edges one after the other, run through at constant speed.
struct Chain {
  struct Link {
    std::function<CurveSample(double t)> curve;
    std::function<SupportSample(double t)> support;
    ArcLength arc;
    double start, end;  // on the chain, 0 to 1
    // CAD edges meet but for a tolerance: the ends are moved to the middle, the rest with them.
    Eigen::Vector3d moveStart = Eigen::Vector3d::Zero(), moveEnd = Eigen::Vector3d::Zero();
  };
  std::vector<Link> links;
  double length = 0.0;

  // The link that holds s, and the parameter of its edge there.
  [[nodiscard]] std::pair<const Link*, double> at(double s) const {
    const Link* link = &links.back();
    for (const Link& l : links)
      if (s < l.end) {
        link = &l;
        break;
      }
    return {link, link->arc.parameterAt((s - link->start) * length)};
  }
};

// Constant speed is not the edges' own: stretches short enough to be taken for affine.
std::vector<Stretch> finer(const std::vector<Stretch>& stretches, const Chain& chain) {
  constexpr int kParts = 8;
  std::vector<Stretch> result;
  for (std::size_t k = 0; k < stretches.size(); ++k)
    for (int m = 0; m < kParts; ++m) {
      const auto edgeAt = [&](int part) {
        return stretches[k].from + (stretches[k].to - stretches[k].from) * part / kParts;
      };
      const auto chainAt = [&](int part) {
        return chain.links[k].start + chain.links[k].arc.lengthUpTo(edgeAt(part)) / chain.length;
      };
      result.push_back({stretches[k].edge,
                        edgeAt(m),
                        edgeAt(m + 1),
                        m == 0 ? chain.links[k].start : chainAt(m),
                        m + 1 == kParts ? chain.links[k].end : chainAt(m + 1)});
    }
  return result;
}

BoundarySide chainOfEdges(const BoundaryLoop& loop, std::vector<Stretch>& stretches) {
  auto chain = std::make_shared<Chain>();
  for (const Stretch& s : stretches) {
    const Ribbon& ribbon = loop.sides[s.edge].ribbon;
    chain->links.push_back(
        {ribbon.curve, ribbon.support, ArcLength(ribbon, s.from, s.to), 0.0, 1.0});
    chain->length += chain->links.back().arc.length();
  }
  BoundarySide side = loop.sides[stretches.front().edge];
  side.stretches.clear();
  side.ribbon = {};
  bool anySupport = false;
  double behind = 0.0;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const BoundarySide& edge = loop.sides[stretches[k].edge];
    Chain::Link& link = chain->links[k];
    link.start = stretches[k].start = behind / chain->length;
    behind += link.arc.length();
    link.end = stretches[k].end = k + 1 == stretches.size() ? 1.0 : behind / chain->length;
    for (const CurveBreak& b : edge.ribbon.breaks) {
      if (!(stretches[k].from < b.t && b.t < stretches[k].to)) continue;
      const double share = link.arc.lengthUpTo(b.t) / chain->length;
      side.ribbon.breaks.push_back({link.start + share, b.continuity});
    }
    if (k + 1 < stretches.size()) side.ribbon.breaks.push_back({link.end, 1});
    side.stretches.push_back({link.end, edge.continuityAt(0.5)});
    side.continuity = std::max(side.continuity, edge.continuity);
    side.supportDeviation = std::max(side.supportDeviation, edge.supportDeviation);
    anySupport = anySupport || edge.ribbon.hasSupport();
  }
  std::vector<double> first, last;
  for (const Stretch& s : stretches) {
    first.push_back(s.from);
    last.push_back(s.to);
  }
  stretches = finer(stretches, *chain);
  for (std::size_t k = 0; k + 1 < chain->links.size(); ++k) {
    Chain::Link &before = chain->links[k], &after = chain->links[k + 1];
    const Eigen::Vector3d gap = after.curve(first[k + 1]).point - before.curve(last[k]).point;
    before.moveEnd = 0.5 * gap;
    after.moveStart = -0.5 * gap;
  }
  side.ribbon.curve = [chain](double s) {
    const auto [link, t] = chain->at(s);
    CurveSample sample = link->curve(t);
    sample.derivative *= chain->length / sample.derivative.norm();
    const double width = link->end - link->start, share = (s - link->start) / width;
    sample.point += (1.0 - share) * link->moveStart + share * link->moveEnd;
    sample.derivative += (link->moveEnd - link->moveStart) / width;
    return sample;
  };
  if (anySupport)
    side.ribbon.support = [chain](double s) {
      const auto [link, t] = chain->at(s);
      if (link->support) return link->support(t);
      SupportSample none;
      none.singular = true;
      return none;
    };
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
    sides.push_back(stretches.size() == 1 && (keeps || !polynomial)
                        ? stretchOfEdge(loop.sides[stretches[0].edge], stretches[0])
                        : chainOfEdges(loop, stretches));
    cut.stretches.push_back(std::move(stretches));
  }
  auto made = makeLoop(std::move(sides));
  if (!made) return fail(made.error());
  cut.loop = std::move(*made);
  cut.loop.diagonal = loop.diagonal;
  return cut;
}

}  // namespace fairing::boundary
