// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/pass_through.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/span/refine.h"
#include "core/spline/bspline_basis.h"
#include "core/spline/nearest_patch.h"

namespace fairing {
namespace {

constexpr int kMeasured = 33;  // places of a curve

std::vector<Eigen::Vector3d> placesOf(const InnerConstraint& constraint, int count) {
  if (constraint.isPoint || count < 2) return {constraint.at(0.0)};
  std::vector<Eigen::Vector3d> places;
  for (int k = 0; k < count; ++k)
    places.push_back(constraint.at(static_cast<double>(k) / (count - 1)));
  return places;
}

solver::TieRow rowAt(const layout::LayoutPatch& patch,
                     const spline::SurfaceFoot& foot,
                     const Eigen::Vector3d& point) {
  const spline::BasisRow bu = spline::basisRow(patch.u, foot.u),
                         bv = spline::basisRow(patch.v, foot.v);
  solver::TieRow row;
  row.right = point;
  for (int i = 0; i <= patch.u.degree(); ++i)
    for (int j = 0; j <= patch.v.degree(); ++j) {
      row.points.push_back(patch.points[static_cast<std::size_t>(
          (bu.first + i) * patch.v.poleCount() + bv.first + j)]);
      row.weights.push_back(bu.values(0, i) * bv.values(0, j));
    }
  return row;
}

// How many places of a curve patches can be held at: their restriction to it is a spline with a
// knot wherever it crosses one of theirs.
int freedomsAlong(const Patches& patches, const InnerConstraint& constraint) {
  if (constraint.isPoint) return 1;
  int crossings = 0, degree = 0;
  std::optional<spline::PatchFoot> before;
  const spline::NearestPatch nearest(patches);
  for (const Eigen::Vector3d& place : placesOf(constraint, kMeasured)) {
    const spline::PatchFoot near = nearest.to(place);
    const spline::BsplineSurface& patch = patches[static_cast<std::size_t>(near.patch)];
    degree = std::max({degree, patch.u.degree(), patch.v.degree()});
    if (before && before->patch == near.patch)
      crossings += std::abs(patch.u.span(near.foot.u) - patch.u.span(before->foot.u)) +
                   std::abs(patch.v.span(near.foot.v) - patch.v.span(before->foot.v));
    before = near;
  }
  return crossings + degree + 1;
}

}  // namespace

std::vector<solver::TieBlock> passThrough(const layout::PatchLayout& layout,
                                          const Patches& about,
                                          const std::vector<InnerConstraint>& constraints,
                                          const std::vector<char>& taken) {
  solver::TieBlock block;
  const spline::NearestPatch nearest(about);
  for (const InnerConstraint& constraint : constraints)
    for (const Eigen::Vector3d& place : placesOf(constraint, freedomsAlong(about, constraint))) {
      const spline::PatchFoot near = nearest.to(place);
      const auto row =
          rowAt(layout.patches[static_cast<std::size_t>(near.patch)], near.foot, place);
      const std::size_t before = block.solvedFor.size();
      for (const int point : row.points)
        if (!taken[static_cast<std::size_t>(point)]) block.solvedFor.push_back(point);
      if (block.solvedFor.size() == before) continue;
      block.rows.push_back(row);
    }
  if (block.rows.empty()) return {};
  return {block};
}

void addInner(analysis::FillReport& report,
              const Patches& patches,
              const std::vector<InnerConstraint>& constraints) {
  const spline::NearestPatch nearest(patches);
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    analysis::InnerReport inner;
    inner.number = static_cast<int>(k) + 1;
    double sum = 0.0;
    const auto places = placesOf(constraints[k], kMeasured);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double distance = nearest.to(places[i]).foot.distance;
      sum += distance * distance;
      if (i > 0 && distance <= inner.gap.max) continue;
      inner.gap.max = distance;
      inner.gap.where = places[i];
      inner.gap.parameter = static_cast<double>(i) / kMeasured;
    }
    inner.gap.count = static_cast<int>(places.size());
    inner.gap.rms = std::sqrt(sum / inner.gap.count);
    report.largestInnerGap = std::max(report.largestInnerGap, inner.gap.max);
    report.inner.push_back(inner);
  }
  report.withinTolerance = report.withinTolerance && report.largestInnerGap <= report.gapLimit;
}

void wishForInner(const layout::PatchLayout& layout,
                  const Patches& patches,
                  const std::vector<InnerConstraint>& constraints,
                  double limit,
                  std::vector<layout::KnotWish>& wishes) {
  const spline::NearestPatch nearest(patches);
  for (const InnerConstraint& constraint : constraints)
    for (const Eigen::Vector3d& place : placesOf(constraint, kMeasured)) {
      const spline::PatchFoot near = nearest.to(place);
      if (near.foot.distance <= limit) continue;
      const auto p = static_cast<std::size_t>(near.patch);
      for (const double knot : middlesAt(layout.patches[p].u, near.foot.u))
        wishes[p].u.push_back(knot);
      for (const double knot : middlesAt(layout.patches[p].v, near.foot.v))
        wishes[p].v.push_back(knot);
    }
}

}  // namespace fairing
