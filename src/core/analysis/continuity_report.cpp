// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/continuity_report.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/analysis/closest_point.h"
#include "core/analysis/curvature.h"
#include "core/analysis/side_samples.h"

namespace fairing::analysis {
namespace {

using boundary::BoundaryLoop;
using boundary::BoundarySide;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kDegrees = 180.0 / std::numbers::pi;
// Curvatures below this over the diagonal count as flat when they are compared.
constexpr double kFlat = 0.01;
// What a twist mismatch leaves near the corner, as a share of mismatch times knot span: the largest
// value of a quintic's first inner basis function with unit slope at the end is about 0.1.
constexpr double kTwistShare = 0.1;
constexpr double kFinestSpan = 1.0 / 64.0;

void add(Deviation& d, double value, const MeasuredFoot& foot) {
  if (d.count == 0 || value > d.max) {
    d.max = value;
    d.where = foot.point;
    d.parameter = foot.t;
  }
  d.rms += value * value;
  ++d.count;
}

void finish(Deviation& d) {
  d.rms = d.count > 0 ? std::sqrt(d.rms / d.count) : 0.0;
}

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * kDegrees;
}

// Direction across the side in the support's tangent plane.
Vector3d acrossSide(const boundary::Ribbon& ribbon, const Vector3d& normal, double t) {
  return normal.cross(ribbon.curve(t).derivative).normalized();
}

SurfaceFoot footOnTrace(const std::vector<spline::BsplineSurface>& patches,
                        const SideTrace& trace,
                        double t,
                        const Vector3d& point) {
  const Vector2d guess =
      trace.start + (trace.end - trace.start) * ((t - trace.from) / (trace.to - trace.from));
  return closestPoint(patches[static_cast<std::size_t>(trace.patch)], point, guess[0], guess[1]);
}

MeasuredFoot measured(const BoundarySide& side,
                      double t,
                      bool inCorner,
                      const std::vector<spline::BsplineSurface>& patches,
                      const SideTrace& trace) {
  MeasuredFoot foot;
  foot.t = t;
  foot.inCorner = inCorner;
  foot.point = side.ribbon.curve(t).point;
  const SurfaceFoot found = footOnTrace(patches, trace, t, foot.point);
  foot.gap = found.distance;
  foot.normal = found.jet.normalVector().normalized();
  foot.curvature = normalCurvature(found.jet, acrossSide(side.ribbon, foot.normal, t));
  return foot;
}

std::vector<MeasuredFoot> measureSide(const BoundarySide& side,
                                      int index,
                                      const std::vector<spline::BsplineSurface>& patches,
                                      const std::vector<SideTrace>& traces) {
  std::vector<MeasuredFoot> feet;
  for (const SidePlace& place : sidePlaces(side.ribbon))
    for (const SideTrace& trace : traces) {
      if (trace.side != index || place.t < trace.from || place.t > trace.to) continue;
      feet.push_back(measured(side, place.t, place.inCorner, patches, trace));
      break;
    }
  return feet;
}

// +1 where most of the patches' normals along the border agree with the supports', else -1.
double orientationOf(const BoundaryLoop& loop, const std::vector<std::vector<MeasuredFoot>>& feet) {
  int balance = 0;
  for (std::size_t k = 0; k < loop.sides.size(); ++k) {
    if (!loop.sides[k].ribbon.hasSupport()) continue;
    for (const MeasuredFoot& foot : feet[k])
      balance += loop.sides[k].ribbon.support(foot.t).normal.dot(foot.normal) >= 0.0 ? 1 : -1;
  }
  return balance >= 0 ? 1.0 : -1.0;
}

bool within(const Deviation& d, double limit) {
  return d.count == 0 || d.max <= limit;
}

}  // namespace

FillReport emptyReport(const BoundaryLoop& loop, const Tolerance& tolerance) {
  FillReport report;
  report.diagonal = loop.diagonal;
  report.gapLimit = tolerance.gapFor(loop.diagonal);
  report.angleLimit = tolerance.angle;
  report.cornerAngleLimit = std::max(tolerance.cornerAngle, tolerance.angle);
  for (const BoundarySide& side : loop.sides) {
    SideReport entry;
    entry.edge = side.edge;
    entry.face = side.face;
    entry.asked = side.continuity;
    entry.supportDeviation = side.supportDeviation;
    report.sides.push_back(entry);
  }
  for (std::size_t k = 0; k < loop.corners.size(); ++k) {
    const boundary::Corner& corner = loop.corners[k];
    CornerReport entry{corner.point,
                       loop.sides[k].edge,
                       loop.sides[(k + 1) % loop.sides.size()].edge,
                       corner.angle,
                       corner.normalMismatch,
                       corner.twistMismatch};
    entry.normalsAgree = corner.normalsAgree(report.angleLimit);
    entry.twistsAgree = kTwistShare * kFinestSpan * corner.twistMismatch <= report.angleLimit;
    report.corners.push_back(entry);
  }
  return report;
}

void addFoot(const BoundarySide& side,
             const MeasuredFoot& foot,
             double diagonal,
             double orientation,
             SideReport& report) {
  add(report.gap, foot.gap, foot);
  if (!side.ribbon.hasSupport()) return;
  const boundary::SupportSample support = side.ribbon.support(foot.t);
  if (support.singular) return;
  const Vector3d normal = orientation * foot.normal;
  const double opposed = angleBetween(normal, support.normal);
  const double angle = std::min(opposed, 180.0 - opposed);
  if (opposed > 90.0) report.backwards = true;
  report.angleCurve.emplace_back(foot.t, angle);
  add(foot.inCorner ? report.cornerAngle : report.angle, angle, foot);
  if (foot.inCorner) return;
  const Vector3d across = acrossSide(side.ribbon, support.normal, foot.t);
  const double asked = across.dot(support.secondForm * across), got = orientation * foot.curvature;
  add(report.curvature,
      std::abs(asked - got) / (std::abs(asked) + std::abs(got) + kFlat / diagonal),
      foot);
}

void finishSide(SideReport& report) {
  for (Deviation* d : {&report.gap, &report.angle, &report.cornerAngle, &report.curvature})
    finish(*d);
}

void judge(FillReport& report) {
  report.largestGap = report.largestAngle = report.largestCornerAngle = 0.0;
  report.withinTolerance = true;
  for (SideReport& side : report.sides) {
    side.withinTolerance = within(side.gap, report.gapLimit);
    report.largestGap = std::max(report.largestGap, side.gap.max);
    if (side.asked != Continuity::G0) {
      side.withinTolerance = side.withinTolerance && !side.backwards &&
                             within(side.angle, report.angleLimit) &&
                             within(side.cornerAngle, report.cornerAngleLimit);
      report.largestAngle = std::max(report.largestAngle, side.angle.max);
      report.largestCornerAngle = std::max(report.largestCornerAngle, side.cornerAngle.max);
    }
    report.withinTolerance = report.withinTolerance && side.withinTolerance;
  }
}

FillReport measureFill(const BoundaryLoop& loop,
                       const std::vector<spline::BsplineSurface>& patches,
                       const std::vector<SideTrace>& traces,
                       const Tolerance& tolerance) {
  FillReport report = emptyReport(loop, tolerance);
  std::vector<std::vector<MeasuredFoot>> feet;
  for (std::size_t k = 0; k < loop.sides.size(); ++k)
    feet.push_back(measureSide(loop.sides[k], static_cast<int>(k), patches, traces));
  const double orientation = orientationOf(loop, feet);
  for (std::size_t k = 0; k < loop.sides.size(); ++k) {
    for (const MeasuredFoot& foot : feet[k])
      addFoot(loop.sides[k], foot, loop.diagonal, orientation, report.sides[k]);
    finishSide(report.sides[k]);
  }
  report.reversed = orientation < 0.0;
  judge(report);
  return report;
}

}  // namespace fairing::analysis
