// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/continuity_report.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"

namespace fairing::analysis {
namespace {

using boundary::BoundaryLoop;
using boundary::BoundarySide;
using Eigen::Vector3d;

// Curvatures below this over the diagonal count as flat when they are compared.
constexpr double kFlat = 0.01;
// What a twist mismatch leaves near the corner, as a share of mismatch times knot span: the largest
// value of a quintic's first inner basis function with unit slope at the end is about 0.1.
constexpr double kTwistShare = 0.1;
constexpr double kFinestSpan = 1.0 / 64.0;
// What the angle next to corners whose twists disagree may be, in limits of the others.
constexpr double kTwistAllowance = 2.0;
constexpr double kDepartureLimit = 0.1;  // degrees

void add(Deviation& d, double value, const ProbePoint& probe) {
  if (d.count == 0 || value > d.max) {
    d.max = value;
    d.where = probe.point;
    d.parameter = probe.t;
  }
  d.rms += value * value;  // a sum of squares until finish()
  ++d.count;
}

void finish(Deviation& d) {
  d.rms = d.count > 0 ? std::sqrt(d.rms / d.count) : 0.0;
}

// Between a patch's cross tangent and the direction a side asks for.
double departureAngle(const ProbePoint& probe,
                      const MeasuredFoot& foot,
                      boundary::Departure asked) {
  if (asked == boundary::Departure::Iso) return lineAngle(foot.across, probe.iso);
  return std::asin(std::min(1.0, std::abs(foot.across.dot(probe.tangent)))) * kDegrees;
}

void addFoot(const ProbePoint& probe, const MeasuredFoot& foot, double flat, SideReport& report) {
  add(report.gap, foot.gap, probe);
  if (!probe.hasNormal) return;
  const double angle = lineAngle(foot.normal, probe.normal);
  // The hole is to the left of the side seen against the support's normal; so must be the patch.
  const double agreement = foot.normal.dot(probe.normal) < 0.0 ? -1.0 : 1.0;
  const double asked = report.askedLeaving == boundary::Leaving::Backwards ? -1.0 : 1.0;
  if (asked * foot.side * agreement < 0.0) report.backwards = true;
  if (report.askedDeparture != boundary::Departure::Free && !foot.across.isZero())
    add(report.departure, departureAngle(probe, foot, report.askedDeparture), probe);
  report.floorAngle = std::max(report.floorAngle, probe.floor);
  report.angleCurve.push_back({probe.t, angle, probe.floor, probe.inCorner});
  add(probe.inCorner ? report.cornerAngle : report.angle, angle, probe);
  if (probe.inCorner) return;
  const double own = probe.curvature, got = agreement * foot.curvature;
  const double mismatch = std::abs(own - got) / (std::abs(own) + std::abs(got) + flat);
  report.angleCurve.back().curvature = mismatch;
  add(report.curvature, mismatch, probe);
}

// Whether most normals along the border are against the supports'.
bool isReversed(const LoopProbe& probe, const std::vector<std::vector<MeasuredFoot>>& feet) {
  int balance = 0;
  for (std::size_t k = 0; k < feet.size(); ++k)
    for (std::size_t i = 0; i < feet[k].size(); ++i)
      if (probe.sides[k][i].hasNormal)
        balance += probe.sides[k][i].normal.dot(feet[k][i].normal) >= 0.0 ? 1 : -1;
  return balance < 0;
}

bool within(const Deviation& d, double limit) {
  return d.count == 0 || d.max <= limit;
}

void judge(FillReport& report) {
  report.withinTolerance = true;
  for (SideReport& side : report.sides) {
    side.withinTolerance = within(side.gap, report.gapLimit);
    report.largestGap = std::max(report.largestGap, side.gap.max);
    if (side.asked != Continuity::G0) {
      side.withinTolerance = side.withinTolerance && !side.backwards &&
                             within(side.angle, report.angleLimit) &&
                             within(side.cornerAngle, side.cornerAngleLimit);
      report.largestAngle = std::max(report.largestAngle, side.angle.max);
      report.largestCornerAngle = std::max(report.largestCornerAngle, side.cornerAngle.max);
    }
    side.withinTolerance = side.withinTolerance && within(side.departure, report.departureLimit);
    if (side.asked == Continuity::G2) {
      side.withinTolerance = side.withinTolerance && within(side.curvature, report.curvatureLimit);
      report.largestCurvature = std::max(report.largestCurvature, side.curvature.max);
    }
    report.withinTolerance = report.withinTolerance && side.withinTolerance;
  }
}

bool twistsAgree(const boundary::Corner& corner, double angleLimit) {
  return kTwistShare * kFinestSpan * corner.twistMismatch <= angleLimit;
}

FillReport emptyReport(const BoundaryLoop& loop, const Tolerance& tolerance) {
  FillReport report;
  report.diagonal = loop.diagonal;
  report.gapLimit = tolerance.gapFor(loop.diagonal);
  report.angleLimit = tolerance.angle;
  report.curvatureLimit = tolerance.curvature;
  report.departureLimit = kDepartureLimit;
  report.cornerAngleLimit = std::max(tolerance.cornerAngle, tolerance.angle);
  for (const BoundarySide& side : loop.sides) {
    SideReport entry;
    entry.edge = side.edge;
    entry.face = side.face;
    entry.asked = side.continuity;
    entry.askedDeparture = side.departure;
    entry.askedLeaving = side.leaving;
    entry.supportDeviation = side.supportDeviation;
    report.sides.push_back(entry);
  }
  for (std::size_t k = 0; k < loop.corners.size(); ++k) {
    const boundary::Corner& corner = loop.corners[k];
    if (corner.apart) continue;
    CornerReport entry;
    entry.point = corner.point;
    entry.sideBefore = k;
    entry.sideAfter = loop.next(k);
    entry.edgeBefore = loop.sides[k].edge;
    entry.edgeAfter = loop.sides[loop.next(k)].edge;
    entry.angle = corner.angle;
    entry.normalMismatch = corner.normalMismatch;
    entry.twistMismatch = corner.twistMismatch;
    entry.normalsAgree = corner.normalsAgree(report.angleLimit);
    entry.twistsAgree = twistsAgree(corner, report.angleLimit);
    report.corners.push_back(entry);
  }
  for (std::size_t k = 0; k < loop.sides.size(); ++k) {
    const bool agree = twistsAgree(loop.corners[loop.previous(k)], report.angleLimit) &&
                       twistsAgree(loop.corners[k], report.angleLimit);
    report.sides[k].cornerAngleLimit = (agree ? 1.0 : kTwistAllowance) * report.cornerAngleLimit;
  }
  return report;
}

}  // namespace

FillReport measureLoop(const BoundaryLoop& loop,
                       const LoopProbe& probe,
                       const Tolerance& tolerance,
                       const FootFinder& footOf) {
  std::vector<std::vector<MeasuredFoot>> feet(probe.sides.size());
  for (std::size_t k = 0; k < probe.sides.size(); ++k)
    for (const ProbePoint& p : probe.sides[k]) feet[k].push_back(footOf(k, p));
  FillReport report = emptyReport(loop, tolerance);
  report.reversed = isReversed(probe, feet);
  for (std::size_t k = 0; k < feet.size(); ++k) {
    SideReport& side = report.sides[k];
    for (std::size_t i = 0; i < feet[k].size(); ++i)
      addFoot(probe.sides[k][i], feet[k][i], kFlat / loop.diagonal, side);
    for (Deviation* d :
         {&side.gap, &side.angle, &side.cornerAngle, &side.curvature, &side.departure})
      finish(*d);
  }
  judge(report);
  return report;
}

}  // namespace fairing::analysis
