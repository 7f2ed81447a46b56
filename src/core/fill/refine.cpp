// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/refine.h"

#include <algorithm>
#include <set>

namespace fairing {
namespace {

using layout::KnotWish;
using layout::LayoutPatch;
using layout::PatchEdge;

// No span becomes shorter than this share of the patch: finer ones cost accuracy.
constexpr double kShortestSpan = 1e-3;

struct EdgeEnds {
  Eigen::Vector2d start, end;
};

EdgeEnds edgeEnds(const LayoutPatch& patch, PatchEdge edge) {
  const double u0 = patch.u.first(), u1 = patch.u.last(), v0 = patch.v.first(), v1 = patch.v.last();
  switch (edge) {
    case PatchEdge::South:
      return {{u0, v0}, {u1, v0}};
    case PatchEdge::East:
      return {{u1, v0}, {u1, v1}};
    case PatchEdge::North:
      return {{u1, v1}, {u0, v1}};
    case PatchEdge::West:
      break;
  }
  return {{u0, v1}, {u0, v0}};
}

// An angle the edge's own tangent forces is not worth a knot; what is beyond it by this factor is.
constexpr double kBeyondFloor = 1.25;

bool isTooLarge(const analysis::AnglePlace& place,
                const analysis::FillReport& report,
                Continuity asked,
                double aim) {
  if (asked == Continuity::G2 && place.curvature > aim * report.curvatureLimit) return true;
  const double limit = place.inCorner ? report.cornerAngleLimit : report.angleLimit;
  return place.angle > std::max(aim * limit, kBeyondFloor * place.floor);
}

// How far over the limits a report is; 1 = just within. The sum over the sides tells reports apart
// whose worst place is the same. A patch that leaves a side backwards is worse than any.
double excess(const analysis::FillReport& report) {
  constexpr double kBackwards = 1e6;
  constexpr double kTieShare = 1e-3;
  double worst = report.largestSeamAngle / report.angleLimit, sum = worst;
  for (const analysis::SideReport& side : report.sides) {
    double own = side.gap.max / report.gapLimit;
    if (side.asked != Continuity::G0) {
      own = std::max({own,
                      side.angle.max / report.angleLimit,
                      side.cornerAngle.max / report.cornerAngleLimit});
      if (side.asked == Continuity::G2)
        own = std::max(own, side.curvature.max / report.curvatureLimit);
      if (side.backwards) own += kBackwards;
    }
    worst = std::max(worst, own);
    sum += own;
  }
  return worst + kTieShare * sum;
}

}  // namespace

std::set<double> middlesAt(const spline::KnotVector& knots, double t) {
  const double width = knots.last() - knots.first(), rounding = 1e-9 * width;
  const std::vector<double> breaks = knots.breaks();
  std::set<double> middles;
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    const double low = breaks[s], high = breaks[s + 1];
    const bool holds = low - rounding <= t && t <= high + rounding;
    if (holds && high - low > 2.0 * kShortestSpan * width) middles.insert(0.5 * (low + high));
  }
  return middles;
}

std::vector<analysis::SideTrace> sideTraces(const layout::LayoutPlan& plan,
                                            const layout::PatchLayout& layout) {
  std::vector<analysis::SideTrace> traces;
  for (std::size_t p = 0; p < layout.patches.size(); ++p)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& use = layout.patches[p].edges[k];
      if (!use) continue;
      const EdgeEnds ends = edgeEnds(layout.patches[p], static_cast<PatchEdge>(k));
      const Eigen::Vector2d way = ends.end - ends.start;
      for (const boundary::Stretch& s : plan.cut.stretches[static_cast<std::size_t>(use->side)])
        traces.push_back({static_cast<int>(s.edge),
                          static_cast<int>(p),
                          s.from,
                          s.to,
                          ends.start + s.start * way,
                          ends.start + s.end * way});
    }
  return traces;
}

std::vector<analysis::SeamTraces> seamTraces(const layout::PatchLayout& layout) {
  std::vector<analysis::SeamTraces> traces;
  for (const layout::Seam& seam : layout.seams) {
    const EdgeEnds a =
        edgeEnds(layout.patches[static_cast<std::size_t>(seam.first)], seam.firstEdge);
    const EdgeEnds b =
        edgeEnds(layout.patches[static_cast<std::size_t>(seam.second)], seam.secondEdge);
    traces.push_back({{seam.first, a.start, a.end}, {seam.second, b.end, b.start}});
  }
  return traces;
}

std::vector<KnotWish> wishedKnots(const layout::LayoutPlan& plan,
                                  const layout::PatchLayout& layout,
                                  const analysis::FillReport& report,
                                  double aim) {
  std::vector<KnotWish> wishes(layout.patches.size());
  std::vector<std::set<double>> u(layout.patches.size()), v(layout.patches.size());
  for (const analysis::SideTrace& trace : sideTraces(plan, layout)) {
    const auto p = static_cast<std::size_t>(trace.patch);
    const analysis::SideReport& side = report.sides[static_cast<std::size_t>(trace.side)];
    if (side.asked == Continuity::G0) continue;
    const bool alongU = trace.start[1] == trace.end[1];
    for (const analysis::AnglePlace& place : side.angleCurve) {
      if (place.t < trace.from || place.t > trace.to || !isTooLarge(place, report, side.asked, aim))
        continue;
      const Eigen::Vector2d at = trace.at(place.t);
      if (alongU)
        u[p].merge(middlesAt(layout.patches[p].u, at[0]));
      else
        v[p].merge(middlesAt(layout.patches[p].v, at[1]));
    }
  }
  const auto seams = seamTraces(layout);
  for (std::size_t k = 0; k < seams.size(); ++k) {
    if (report.seams[k].angle.max <= aim * report.angleLimit) continue;
    const analysis::SeamTrace& trace = seams[k].first;
    const auto p = static_cast<std::size_t>(trace.patch);
    const Eigen::Vector2d at =
        trace.start + report.seams[k].angle.parameter * (trace.end - trace.start);
    if (layout::directionOf(layout.seams[k].firstEdge) == 0)
      u[p].merge(middlesAt(layout.patches[p].u, at[0]));
    else
      v[p].merge(middlesAt(layout.patches[p].v, at[1]));
  }
  for (std::size_t p = 0; p < wishes.size(); ++p) {
    wishes[p].u.assign(u[p].begin(), u[p].end());
    wishes[p].v.assign(v[p].begin(), v[p].end());
  }
  return wishes;
}

bool nothingWished(const std::vector<KnotWish>& wishes) {
  return std::all_of(wishes.begin(), wishes.end(), [](const KnotWish& w) { return w.empty(); });
}

FillResult better(FillResult before, FillResult after) {
  if (excess(after.report) < excess(before.report)) return after;
  before.summary.solves = after.summary.solves;
  return before;
}

}  // namespace fairing
