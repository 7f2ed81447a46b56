// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/measure_trimmed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/curvature.h"
#include "core/analysis/measure_fairness.h"
#include "core/height_field/domain_grid.h"
#include "core/spline/closest_point.h"

namespace fairing {
namespace {

using analysis::FillReport;
using Eigen::Vector3d;

constexpr int kInnerSamples = 101;   // of a curve the surface passes through
constexpr int kFairnessPoints = 3;   // a span
constexpr int kSupportSamples = 33;  // a side
// Above this the plane is told to be unfit.
constexpr double kTooSteep = 75.0;

spline::SurfaceFoot footBelow(const TrimmedHole& hole,
                              const spline::BsplineSurface& surface,
                              const Vector3d& point) {
  const Vector3d at = hole.frame.coordinates(point);
  return spline::closestPoint(surface,
                              point,
                              std::clamp(at[0], surface.u.first(), surface.u.last()),
                              std::clamp(at[1], surface.v.first(), surface.v.last()));
}

double distanceFromLoop(const TrimmedHole& hole, const Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& side : hole.probe.sides)
    for (const analysis::ProbePoint& probe : side)
      least = std::min(least, (probe.point - point).norm());
  return least;
}

// Of the points of a constraint, with its parameters.
std::vector<double> parametersOf(const InnerConstraint& inner) {
  if (inner.isPoint) return {0.0};
  std::vector<double> all;
  for (int k = 0; k < kInnerSamples; ++k) all.push_back(k / (kInnerSamples - 1.0));
  return all;
}

// Where the foot is trimmed away the loop is what is left of the surface.
double distanceFromFace(const TrimmedHole& hole,
                        const spline::BsplineSurface& surface,
                        const Vector3d& point) {
  const spline::SurfaceFoot foot = footBelow(hole, surface, point);
  return hole.projected.contains({foot.u, foot.v}) ? foot.distance : distanceFromLoop(hole, point);
}

void measureInner(const TrimmedHole& hole,
                  const spline::BsplineSurface& surface,
                  const std::vector<InnerConstraint>& through,
                  FillReport& report) {
  for (std::size_t k = 0; k < through.size(); ++k) {
    analysis::InnerReport inner{static_cast<int>(k) + 1, {}};
    for (const double t : parametersOf(through[k])) {
      const Vector3d point = through[k].at(t);
      const double gap = distanceFromFace(hole, surface, point);
      if (inner.gap.count == 0 || gap > inner.gap.max) {
        inner.gap.max = gap;
        inner.gap.where = point;
        inner.gap.parameter = t;
      }
      inner.gap.rms += gap * gap;
      ++inner.gap.count;
    }
    inner.gap.rms = std::sqrt(inner.gap.rms / inner.gap.count);
    report.largestInnerGap = std::max(report.largestInnerGap, inner.gap.max);
    report.withinTolerance = report.withinTolerance && inner.gap.max <= report.gapLimit;
    report.inner.push_back(inner);
  }
}

// The first place of a side where its support fails to say what is asked.
std::optional<analysis::Note> noteOn(const boundary::BoundarySide& side) {
  if (!side.isTangent()) return std::nullopt;
  for (int k = 0; k < kSupportSamples; ++k) {
    const double t = k / (kSupportSamples - 1.0);
    const boundary::SupportSample support = side.ribbon.support(t);
    const Vector3d point = side.ribbon.curve(t).point;
    if (support.singular)
      return analysis::Note{analysis::NoteCode::SupportSingular, side.edge, point};
    if (side.continuity == Continuity::G2 && !support.secondForm.allFinite())
      return analysis::Note{analysis::NoteCode::CurvatureUnknown, side.edge, point};
  }
  return std::nullopt;
}

std::vector<analysis::Note> notesOn(const TrimmedHole& hole) {
  std::vector<analysis::Note> notes;
  for (const boundary::BoundarySide& side : hole.loop.sides)
    if (const auto note = noteOn(side)) notes.push_back(*note);
  const auto steep = height_field::steepness(hole.loop, hole.frame);
  if (steep.degrees > kTooSteep)
    notes.push_back({analysis::NoteCode::LoopUnfit, steep.edge, steep.where, steep.degrees});
  return notes;
}

}  // namespace

std::optional<Error> farInnerConstraint(const TrimmedHole& hole,
                                        const std::vector<InnerConstraint>& through) {
  for (const InnerConstraint& inner : through)
    for (const double t : parametersOf(inner)) {
      const Vector3d point = inner.at(t);
      if (!point.allFinite()) return Error{ErrorCode::NotFinite};
      const double distance = distanceFromLoop(hole, point);
      if (distance > hole.loop.diagonal)
        return Error{.code = ErrorCode::InnerConstraintOff, .where = point, .value = distance};
    }
  return std::nullopt;
}

FillResult measureTrimmed(const TrimmedHole& hole,
                          spline::BsplineSurface surface,
                          const FillOptions& options) {
  // The loop runs counter-clockwise in the plane, and u x v is up: the surface lies to its left.
  const double left = hole.projected.area > 0.0 ? 1.0 : -1.0;
  const auto footOf = [&](std::size_t, const analysis::ProbePoint& probe) {
    const spline::SurfaceFoot foot = footBelow(hole, surface, probe.point);
    const Vector3d normal = foot.jet.normalVector().normalized();
    const double curvature = analysis::normalCurvature(foot.jet, normal.cross(probe.tangent));
    return analysis::MeasuredFoot{foot.distance, normal, curvature, left};
  };
  FillResult result;
  result.layout = LayoutKind::Trimmed;
  result.report = analysis::measureLoop(hole.loop, hole.probe, options.tolerance, footOf);
  for (std::size_t k = 0; k < hole.target.sides.size(); ++k)
    result.report.sides[k].followedBy = hole.target.sides[k].followedBy;
  result.report.notes = notesOn(hole);
  measureInner(hole, surface, options.through, result.report);
  result.reversed = {result.report.reversed};
  result.patches = {std::move(surface)};
  return result;
}

analysis::FairnessReport trimmedFairness(const TrimmedHole& hole,
                                         const spline::BsplineSurface& surface) {
  analysis::FairnessSum sum(hole.loop.diagonal);
  const height_field::DomainGrid grid(surface.u, surface.v, hole.projected, kFairnessPoints);
  grid.visit(
      [&](const height_field::DomainGrid::Place& place) {
        if (!place.inside) return;
        sum.add(spline::thirdOrderJet(surface.derivatives(place.u, place.v, 3)), place.weight);
      },
      [] {});
  return sum.report();
}

}  // namespace fairing
