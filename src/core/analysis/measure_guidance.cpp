// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/measure_guidance.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/angle.h"
#include "core/energy/guidance_samples.h"

namespace fairing::analysis {
namespace {

using Eigen::Vector3d;
using energy::Guidance;
using energy::WeightedSample;
using Patches = std::vector<spline::BsplineSurface>;

// A reference that misses less than this share of the patches is not worth a note.
constexpr double kWholly = 1.0 - 1e-9;

/// Calls visit(patch, sample) for every sample on a face.
template <class Visit>
void forEachSample(const Guidance& guidance,
                   const Patches& patches,
                   const OnFace& onFace,
                   const Visit& visit) {
  const energy::NormalFeet feet(guidance, patches);
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const WeightedSample& s :
         energy::guidanceSamples(guidance, feet, patches[p].u, patches[p].v, patches[p]))
      if (!onFace || onFace(p, s.u, s.v)) visit(patches[p], s);
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

}  // namespace

Result<GuidanceReport> measureGuidance(const Guidance& guidance,
                                       const Patches& patches,
                                       const OnFace& onFace) {
  Sum sum;
  double referred = 0.0, covered = 0.0;
  std::vector<Vector3d> places;  // where handles and curves are looked up
  forEachSample(energy::weighingOne(guidance),
                patches,
                onFace,
                [&](const auto& patch, const WeightedSample& s) {
                  const spline::SurfaceJet jet = patch.jet(s.u, s.v);
                  const Vector3d normal = jet.normalVector();
                  const bool speaks = s.guide.lambda > 0.0 || s.guide.gamma > 0.0;
                  if (s.kind == energy::GuideKind::Normals) places.push_back(jet.point);
                  if (s.kind == energy::GuideKind::Reference) {
                    referred += s.weight;
                    covered += speaks ? s.weight : 0.0;
                  }
                  if (s.guide.lambda > 0.0 && s.guide.normal.norm() > 0.0 && normal.norm() > 0.0)
                    sum.addAngle(
                        jet.point, lineAngle(normal, s.guide.normal), s.weight * s.guide.lambda);
                  if (s.guide.gamma > 0.0)
                    sum.addDistance((jet.point - s.guide.point).norm(), s.weight * s.guide.gamma);
                });
  if (const auto idle = energy::NormalFeet(guidance, patches).idle(places))
    return fail({.code = ErrorCode::HandleOff,
                 .where = idle->point,
                 .value = idle->distance,
                 .detail = (idle->isCurve ? "Curve " : "Handle ") + std::to_string(idle->number)});
  if (referred > 0.0 && !(covered > 0.0)) return fail({.code = ErrorCode::ReferenceOff});
  GuidanceReport report = sum.finish();
  report.covered = referred > 0.0 ? covered / referred : 1.0;
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
