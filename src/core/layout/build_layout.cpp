// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/build_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/layout/seam_frames.h"
#include "core/layout/side_curves.h"

namespace fairing::layout {
namespace {

using spline::BsplineCurve;
using spline::KnotVector;

// Length of a quad's edge: of its side, or of the seam in the picture.
double lengthOf(const LayoutPlan& plan, const Quad& quad, std::size_t k) {
  if (quad.sides[k] >= 0)
    return plan.cut.loop.sides[static_cast<std::size_t>(quad.sides[k])].length;
  return plan.mesh.way(quad.vertices[k], quad.vertices[(k + 1) % 4]).norm();
}

// Widths of the strips in the patches' domains: mean lengths, scaled to an area of 1 in all.
std::vector<double> stripWidths(const LayoutPlan& plan, const Strips& strips) {
  std::vector<double> sums(static_cast<std::size_t>(strips.count), 0.0), counts = sums;
  for (std::size_t q = 0; q < plan.mesh.quads.size(); ++q)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto strip = static_cast<std::size_t>(strips.uses[q][k % 2].strip);
      sums[strip] += lengthOf(plan, plan.mesh.quads[q], k);
      counts[strip] += 1.0;
    }
  for (std::size_t s = 0; s < sums.size(); ++s) sums[s] /= counts[s];
  double area = 0.0;
  for (const auto& uses : strips.uses)
    area += sums[static_cast<std::size_t>(uses[0].strip)] *
            sums[static_cast<std::size_t>(uses[1].strip)];
  for (double& width : sums) width /= std::sqrt(area);
  return sums;
}

// A side as a curve on the knots (over [0, 1]) of the patch edge that covers it.
SideCurve curveAlong(const boundary::BoundarySide& side, PatchEdge edge, const KnotVector& knots) {
  SideCurve curve = curveOnKnots({&side, falls(edge)}, knots);
  if (falls(edge)) curve.curve = spline::reversed(curve.curve);
  return curve;
}

// The ends of neighbouring edges differ by a CAD tolerance: the patches' corner lies half way.
void joinEnds(const boundary::BoundaryLoop& loop, SideUse& use) {
  const auto k = static_cast<std::size_t>(use.side);
  const boundary::Corner &start = loop.corners[loop.previous(k)], &end = loop.corners[k];
  if (!start.apart) use.curve.poles.topRows<1>() = start.point.transpose();
  if (!end.apart) use.curve.poles.bottomRows<1>() = end.point.transpose();
}

// Numbers the control points, those on seams and at vertices once.
class Numbering {
 public:
  void number(const Quad& quad, LayoutPatch& patch) {
    patch.points.assign(static_cast<std::size_t>(patch.u.poleCount() * patch.v.poleCount()), -1);
    for (std::size_t k = 0; k < 4; ++k) takeOver(quad, k, patch);
    for (int& point : patch.points)
      if (point < 0) point = count_++;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto points = edgePoints(patch, kPatchEdges[k], 0);
      known_[{quad.vertices[k], quad.vertices[(k + 1) % 4]}] = points;
      vertices_[quad.vertices[k]] = points.front();
    }
  }
  [[nodiscard]] int count() const { return count_; }

 private:
  void takeOver(const Quad& quad, std::size_t k, LayoutPatch& patch) {
    const int from = quad.vertices[k], to = quad.vertices[(k + 1) % 4];
    const auto places = edgePlaces(patch, kPatchEdges[k], 0);
    if (const auto vertex = vertices_.find(from); vertex != vertices_.end())
      patch.points[places.front()] = vertex->second;
    if (quad.sides[k] >= 0) return;
    const auto other = known_.find({to, from});
    if (other == known_.end()) return;
    for (std::size_t i = 0; i < places.size(); ++i)
      patch.points[places[i]] = other->second[places.size() - 1 - i];
  }
  std::map<std::pair<int, int>, std::vector<int>> known_;  // by the vertices of a directed edge
  std::map<int, int> vertices_;
  int count_ = 0;
};

KnotVector patchKnots(const PatchLayout& layout, std::size_t quad, std::size_t direction) {
  const StripUse use = layout.strips.uses[quad][direction];
  const KnotVector& knots = layout.stripKnots[static_cast<std::size_t>(use.strip)];
  return use.reversed ? knots.reversed() : knots;
}

}  // namespace

PatchLayout buildLayout(const LayoutPlan& plan, std::vector<KnotVector> stripKnots) {
  PatchLayout layout;
  layout.kind = plan.kind;
  layout.closed = plan.closed;
  layout.strips = stripsOf(plan.mesh);
  layout.stripKnots = std::move(stripKnots);
  const std::vector<double> widths = stripWidths(plan, layout.strips);
  Numbering numbering;
  for (std::size_t q = 0; q < plan.mesh.quads.size(); ++q) {
    const Quad& quad = plan.mesh.quads[q];
    LayoutPatch patch;
    std::array<KnotVector, 2> knots;
    std::array<double, 2> width{};
    for (std::size_t d = 0; d < 2; ++d) {
      knots[d] = patchKnots(layout, q, d);
      width[d] = widths[static_cast<std::size_t>(layout.strips.uses[q][d].strip)];
    }
    patch.u = knots[0].mapped(0.0, width[0]);
    patch.v = knots[1].mapped(0.0, width[1]);
    for (std::size_t k = 0; k < 4; ++k) {
      if (quad.sides[k] < 0) continue;
      const auto& side = plan.cut.loop.sides[static_cast<std::size_t>(quad.sides[k])];
      SideCurve curve = curveAlong(side, kPatchEdges[k], knots[k % 2]);
      curve.curve.knots = curve.curve.knots.mapped(0.0, width[k % 2]);
      patch.edges[k] = SideUse{quad.sides[k], std::move(curve.curve)};
      joinEnds(plan.cut.loop, *patch.edges[k]);
      layout.curveDeviation = std::max(layout.curveDeviation, curve.deviation);
    }
    numbering.number(quad, patch);
    layout.patches.push_back(std::move(patch));
  }
  layout.pointCount = numbering.count();
  for (const QuadSeam& seam : plan.mesh.seams()) layout.seams.push_back(seamOf(plan, seam));
  return layout;
}

}  // namespace fairing::layout
