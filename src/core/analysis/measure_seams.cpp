// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/measure_seams.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/analysis/curvature.h"
#include "core/base/angle.h"

namespace fairing::analysis {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 33;
constexpr double kFlat = 0.01;

void add(Deviation& d, double value, const Vector3d& where, double t) {
  if (d.count == 0 || value > d.max) {
    d.max = value;
    d.where = where;
    d.parameter = t;
  }
  d.rms = std::sqrt((d.rms * d.rms * d.count + value * value) / (d.count + 1));
  ++d.count;
}

}  // namespace

std::vector<SeamReport> measureSeams(const std::vector<spline::BsplineSurface>& patches,
                                     const std::vector<SeamTraces>& seams,
                                     double diagonal) {
  std::vector<SeamReport> reports;
  double largest = kFlat / diagonal;
  for (const SeamTraces& seam : seams) {
    SeamReport report;
    report.patch = seam.first.patch;
    report.other = seam.second.patch;
    report.crease = seam.crease;
    report.asked = seam.asked;
    const auto jetAt = [&](const SeamTrace& trace, double t) {
      const Eigen::Vector2d at = trace.start + t * (trace.end - trace.start);
      return patches[static_cast<std::size_t>(trace.patch)].jet(at.x(), at.y());
    };
    Vector3d before = jetAt(seam.first, 0.0).point;
    for (int k = 0; k < kSamples; ++k) {
      const double t = (k + 0.5) / kSamples;
      const spline::SurfaceJet a = jetAt(seam.first, t), b = jetAt(seam.second, t);
      const Vector3d na = a.normalVector().normalized(), nb = b.normalVector().normalized();
      add(report.gap, (a.point - b.point).norm(), a.point, t);
      const double angle = angleBetween(na, nb);
      add(report.angle, angle, a.point, t);
      const Vector3d across = na.cross(a.point - before).normalized();
      const double ka = normalCurvature(a, across), kb = normalCurvature(b, across);
      add(report.curvature,
          std::abs(ka - kb) / (std::abs(ka) + std::abs(kb) + kFlat / diagonal),
          a.point,
          t);
      add(report.jump, std::abs(ka - kb), a.point, t);
      report.angleCurve.push_back({.t = t, .angle = angle, .curvature = std::abs(ka - kb)});
      largest = std::max({largest, std::abs(ka), std::abs(kb)});
      before = a.point;
    }
    reports.push_back(report);
  }
  for (SeamReport& report : reports) {
    report.jump.max /= largest;
    report.jump.rms /= largest;
    for (AnglePlace& place : report.angleCurve) place.curvature /= largest;
  }
  return reports;
}

void addSeams(FillReport& report,
              const std::vector<spline::BsplineSurface>& patches,
              const std::vector<SeamTraces>& seams) {
  report.seams = measureSeams(patches, seams, report.diagonal);
  for (const SeamReport& seam : report.seams) {
    report.largestSeamGap = std::max(report.largestSeamGap, seam.gap.max);
    if (seam.crease) continue;
    report.largestSeamAngle = std::max(report.largestSeamAngle, seam.angle.max);
    if (seam.asksCurvature())
      report.largestSeamJump = std::max(report.largestSeamJump, seam.jump.max);
  }
  report.withinTolerance = report.withinTolerance && report.largestSeamGap <= report.gapLimit &&
                           report.largestSeamAngle <= report.angleLimit &&
                           report.largestSeamJump <= report.curvatureLimit;
}

}  // namespace fairing::analysis
