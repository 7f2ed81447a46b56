// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/refine.h"

#include <algorithm>
#include <cmath>
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

// How far an angle is above what is aimed at there; above 1 it is worth a knot.
double share(const analysis::AnglePlace& place,
             const analysis::SideReport& side,
             const analysis::FillReport& report,
             double aim) {
  const double limit = place.inCorner ? side.cornerAngleLimit : report.angleLimit;
  return place.angle / std::max(aim * limit, kBeyondFloor * place.floor);
}

bool isTooLarge(const analysis::AnglePlace& place,
                const analysis::SideReport& side,
                const analysis::FillReport& report,
                double aim) {
  if (side.asked == Continuity::G2 && place.curvature > aim * report.curvatureLimit) return true;
  return share(place, side, report, aim) > 1.0;
}

// What twists that disagree leave at a corner falls as fast as the span next to it, so that the
// halvings it takes are known beforehand. Not all at once: they are not needed where the angle
// falls faster than that.
constexpr int kMostHalvings = 4;

int halvingsFor(double share) {
  return std::clamp(static_cast<int>(std::ceil(std::log2(share))), 1, kMostHalvings);
}

// The knots that halve the span next to an end of the patch again and again.
std::set<double> gradedTo(bool start, const spline::KnotVector& knots, int halvings) {
  const std::vector<double> breaks = knots.breaks();
  const double end = start ? breaks.front() : breaks.back();
  const double next = start ? breaks[1] : breaks[breaks.size() - 2];
  const double shortest = kShortestSpan * (knots.last() - knots.first());
  std::set<double> graded;
  double width = next - end;
  for (int k = 0; k < halvings && std::abs(width) > 2.0 * shortest; ++k) {
    width *= 0.5;
    graded.insert(end + width);
  }
  return graded;
}

// Whether the twists at the start (or end) of a side disagree.
bool twistsDisagree(const analysis::FillReport& report, std::size_t side, bool start) {
  return std::any_of(
      report.corners.begin(), report.corners.end(), [&](const analysis::CornerReport& corner) {
        return (start ? corner.sideAfter : corner.sideBefore) == side && !corner.twistsAgree;
      });
}

// The knots along the stretch of a side that runs on one patch edge, in the patch's direction
// `axis`.
std::set<double> wishedAlong(const analysis::SideTrace& trace,
                             int axis,
                             const spline::KnotVector& knots,
                             const analysis::FillReport& report,
                             double aim) {
  std::set<double> wished;
  const auto number = static_cast<std::size_t>(trace.side);
  const analysis::SideReport& side = report.sides[number];
  if (side.asked == Continuity::G0) return wished;
  const std::vector<double> breaks = knots.breaks();
  double worstLow = 0.0, worstHigh = 0.0;  // shares in the spans next to the patch's ends
  for (const analysis::AnglePlace& place : side.angleCurve) {
    if (place.t < trace.from || place.t > trace.to || !isTooLarge(place, side, report, aim))
      continue;
    const double at = trace.at(place.t)[axis];
    wished.merge(middlesAt(knots, at));
    const double over = share(place, side, report, aim);
    if (at < breaks[1]) worstLow = std::max(worstLow, over);
    if (at > breaks[breaks.size() - 2]) worstHigh = std::max(worstHigh, over);
  }
  const bool rises = trace.end[axis] > trace.start[axis];
  for (const bool start : {true, false}) {
    const bool isCorner = start ? trace.from == 0.0 : trace.to == 1.0;
    const double worst = start == rises ? worstLow : worstHigh;
    if (isCorner && worst > 1.0 && twistsDisagree(report, number, start))
      wished.merge(gradedTo(start == rises, knots, halvingsFor(worst)));
  }
  return wished;
}

// Where a seam is to be refined: at its worst place; in blends, where seams are long and bent,
// wherever they are too wide; and wherever curvature jumps that is not to.
std::vector<double> wideOpen(const analysis::SeamReport& seam,
                             LayoutKind kind,
                             const analysis::FillReport& report,
                             double aim) {
  const double limit = aim * report.angleLimit;
  const bool isBlend = kind == LayoutKind::Strip || kind == LayoutKind::Junction;
  std::vector<double> places;
  if (seam.crease) return places;
  if (!isBlend && seam.angle.max > limit) places.push_back(seam.angle.parameter);
  for (const analysis::AnglePlace& place : seam.angleCurve) {
    const bool jumps = seam.asksCurvature() && place.curvature > aim * report.curvatureLimit;
    if (jumps || (isBlend && place.angle > limit)) places.push_back(place.t);
  }
  return places;
}

}  // namespace

double excess(const analysis::FillReport& report) {
  constexpr double kBackwards = 1e6;
  constexpr double kTieShare = 1e-3;
  double worst = std::max({report.largestSeamAngle / report.angleLimit,
                           report.largestSeamJump / report.curvatureLimit,
                           report.largestInnerGap / report.gapLimit});
  double sum = worst;
  for (const analysis::SideReport& side : report.sides) {
    double own = side.gap.max / report.gapLimit;
    if (side.asked != Continuity::G0) {
      own = std::max(
          {own, side.angle.max / report.angleLimit, side.cornerAngle.max / side.cornerAngleLimit});
      if (side.asked == Continuity::G2)
        own = std::max(own, side.curvature.max / report.curvatureLimit);
      if (side.backwards) own += kBackwards;
    }
    worst = std::max(worst, own);
    sum += own;
  }
  return worst + kTieShare * sum;
}

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
    traces.push_back({{seam.first, a.start, a.end},
                      {seam.second, b.end, b.start},
                      seam.crease,
                      seam.continuity});
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
    const bool alongU = trace.start[1] == trace.end[1];
    (alongU ? u : v)[p].merge(wishedAlong(
        trace, alongU ? 0 : 1, alongU ? layout.patches[p].u : layout.patches[p].v, report, aim));
  }
  const auto seams = seamTraces(layout);
  for (std::size_t k = 0; k < seams.size(); ++k) {
    const analysis::SeamTrace& trace = seams[k].first;
    const auto p = static_cast<std::size_t>(trace.patch);
    for (const double t : wideOpen(report.seams[k], layout.kind, report, aim)) {
      const Eigen::Vector2d at = trace.start + t * (trace.end - trace.start);
      if (layout::directionOf(layout.seams[k].firstEdge) == 0)
        u[p].merge(middlesAt(layout.patches[p].u, at[0]));
      else
        v[p].merge(middlesAt(layout.patches[p].v, at[1]));
    }
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
