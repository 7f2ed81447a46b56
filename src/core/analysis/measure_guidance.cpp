// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/measure_guidance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/energy/guidance_samples.h"

namespace fairing::analysis {
namespace {

using Eigen::Vector3d;
using energy::Guidance;
using energy::WeightedSample;
using Patches = std::vector<spline::BsplineSurface>;

// A reference that misses less than this share of the patches is not worth a note.
constexpr double kWholly = 1.0 - 1e-9;
constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Calls visit(patch, sample) for every sample on a face.
template <class Visit>
void forEachSample(const Guidance& guidance,
                   const Patches& patches,
                   const OnFace& onFace,
                   const Visit& visit) {
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const WeightedSample& s :
         energy::guidanceSamples(guidance, patches[p].u, patches[p].v, patches[p]))
      if (!onFace || onFace(p, s.u, s.v)) visit(patches[p], s);
}

/// Between two lines, degrees, 0 to 90: the energies do not tell N from -N.
double angleBetween(const Vector3d& a, const Vector3d& b) {
  return kDegrees * std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

class Sum {
 public:
  void addAngle(const Vector3d& where, double angle, double weight) {
    if (report_.normals++ == 0 || angle > report_.largestAngle) {
      report_.largestAngle = angle;
      report_.where = where;
    }
    angles_ += weight * angle * angle;
    angleWeight_ += weight;
  }
  void addDistance(double distance, double weight) {
    ++report_.points;
    distances_ += weight * distance * distance;
    distanceWeight_ += weight;
  }
  [[nodiscard]] GuidanceReport finish() {
    if (angleWeight_ > 0.0) report_.rmsAngle = std::sqrt(angles_ / angleWeight_);
    if (distanceWeight_ > 0.0) report_.rmsDistance = std::sqrt(distances_ / distanceWeight_);
    return report_;
  }

 private:
  GuidanceReport report_;
  double angles_ = 0.0, angleWeight_ = 0.0, distances_ = 0.0, distanceWeight_ = 0.0;
};

/// Share of the patches' parameters at which the reference knows a point or a normal.
double coverage(const Guidance& unit, const Patches& patches, const OnFace& onFace) {
  Guidance only;
  only.lambda = only.gamma = 1.0;
  only.reference = unit.reference;
  double all = 0.0, covered = 0.0;
  forEachSample(only, patches, onFace, [&](const auto&, const WeightedSample& s) {
    all += s.weight;
    if (s.guide.lambda > 0.0 || s.guide.gamma > 0.0) covered += s.weight;
  });
  return all > 0.0 ? covered / all : 0.0;
}

/// How far a handle is from the nearest sample, if it reaches none.
std::optional<double> missedBy(const energy::NormalHandle& handle,
                               const Patches& patches,
                               const OnFace& onFace) {
  Guidance everywhere;  // a reference is looked up where handles are
  everywhere.lambda = 1.0;
  double nearest = std::numeric_limits<double>::infinity();
  everywhere.reference = [&](const Vector3d& here) {
    nearest = std::min(nearest, (here - handle.point).norm());
    return energy::GuidanceSample{};
  };
  forEachSample(everywhere, patches, onFace, [](const auto&, const auto&) {});
  return nearest < handle.radius ? std::nullopt : std::optional(nearest);
}

}  // namespace

Result<GuidanceReport> measureGuidance(const Guidance& guidance,
                                       const Patches& patches,
                                       const OnFace& onFace) {
  for (std::size_t k = 0; k < guidance.handles.size(); ++k)
    if (const auto distance = missedBy(guidance.handles[k], patches, onFace))
      return fail({.code = ErrorCode::HandleOff,
                   .where = guidance.handles[k].point,
                   .value = *distance,
                   .detail = std::to_string(k + 1)});
  Guidance unit = guidance;
  unit.lambda = unit.gamma = 1.0;
  const double covered = guidance.reference ? coverage(unit, patches, onFace) : 1.0;
  if (!(covered > 0.0)) return fail({.code = ErrorCode::ReferenceOff});
  Sum sum;
  forEachSample(unit, patches, onFace, [&](const auto& patch, const WeightedSample& s) {
    const spline::SurfaceJet jet = patch.jet(s.u, s.v);
    const Vector3d normal = jet.normalVector();
    if (s.guide.lambda > 0.0 && s.guide.normal.norm() > 0.0 && normal.norm() > 0.0)
      sum.addAngle(jet.point, angleBetween(normal, s.guide.normal), s.weight * s.guide.lambda);
    if (s.guide.gamma > 0.0)
      sum.addDistance((jet.point - s.guide.point).norm(), s.weight * s.guide.gamma);
  });
  GuidanceReport report = sum.finish();
  report.covered = covered;
  return report;
}

std::optional<Note> shortReference(const GuidanceReport& report) {
  if (report.covered >= kWholly) return std::nullopt;
  return Note{.code = NoteCode::ReferenceShort, .value = 1.0 - report.covered};
}

Result<void> addGuidance(FillReport& report,
                         const Guidance& guidance,
                         const Patches& patches,
                         const OnFace& onFace) {
  if (!guidance.isGiven()) return {};
  const auto measured = measureGuidance(guidance, patches, onFace);
  if (!measured) return fail(measured.error());
  report.guidance = *measured;
  if (const auto note = shortReference(*measured)) report.notes.push_back(*note);
  return {};
}

}  // namespace fairing::analysis
