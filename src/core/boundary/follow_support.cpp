// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/follow_support.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/tolerance.h"

namespace fairing::boundary {
namespace {

constexpr int kSamples = 120;
constexpr double kDifferenceStep = 1e-5;
constexpr double kFarthestShare = 1e-4;  // of the diagonal: what real CAD files are off by
constexpr double kEndsShare = 1e-8;      // of the diagonal: an end closer than this does not move
// The moved curve is fitted to this share of the way it moved.
constexpr double kFitShare = 2e-2;
constexpr int kDegree = 5, kMostPoles = 80;

struct Offset {
  double angleRatio =
      0.0;  // largest angle of the tangent to the tangent plane, over what is allowed there
  double distance = 0.0;  // largest distance of the curve from the face, mm
  double atEnds = 0.0;    // the same of the two ends
};

Offset offsetOf(const Ribbon& ribbon, double angle, double cornerAngle) {
  Offset worst;
  for (int k = 0; k <= kSamples; ++k) {
    const double t = static_cast<double>(k) / kSamples;
    const SupportSample support = ribbon.support(t);
    if (support.singular) continue;
    const CurveSample curve = ribbon.curve(t);
    const double sine = std::abs(support.normal.dot(curve.derivative.normalized()));
    const double allowed = t < kCornerZone || t > 1.0 - kCornerZone ? cornerAngle : angle;
    worst.angleRatio = std::max(
        worst.angleRatio, std::asin(std::min(1.0, sine)) * 180.0 / std::numbers::pi / allowed);
    const double distance = (support.point - curve.point).norm();
    worst.distance = std::max(worst.distance, distance);
    if (k == 0 || k == kSamples) worst.atEnds = std::max(worst.atEnds, distance);
  }
  return worst;
}

// The curve moved by `share` of the way to its foot on the support.
CurveSample moved(const Ribbon& ribbon, double share, double t) {
  const auto way = [&](double s) -> Eigen::Vector3d {
    return ribbon.support(s).point - ribbon.curve(s).point;
  };
  const double before = std::max(0.0, t - kDifferenceStep),
               after = std::min(1.0, t + kDifferenceStep);
  const CurveSample own = ribbon.curve(t);
  return {own.point + share * way(t),
          own.derivative + share * (way(after) - way(before)) / (after - before)};
}

spline::BsplineCurve movedCurve(const Ribbon& ribbon, double share, double tolerance) {
  const auto given = [&](double t) { return moved(ribbon, share, t); };
  const auto knots =
      spline::knotsThatFit({given}, spline::KnotVector::bezier(kDegree), tolerance, kMostPoles);
  return spline::fitCurve(given, knots).curve;
}

void setCurve(Ribbon& ribbon, const spline::BsplineCurve& curve) {
  ribbon.polynomial = curve;
  ribbon.curve = [curve](double t) { return CurveSample{curve.evaluate(t), curve.evaluate(t, 1)}; };
  ribbon.breaks.clear();
}

}  // namespace

BoundaryLoop followSupports(const BoundaryLoop& loop, double angle, double cornerAngle) {
  BoundaryLoop followed = loop;
  for (BoundarySide& side : followed.sides) {
    if (!side.isTangent()) continue;
    if (side.supportDeviation <= kEndsShare * loop.diagonal) continue;
    const Offset offset = offsetOf(side.ribbon, angle, cornerAngle);
    if (offset.angleRatio <= 1.0 || offset.atEnds > kEndsShare * loop.diagonal) continue;
    const double share = 1.0 - 1.0 / offset.angleRatio;
    if (share * offset.distance > kFarthestShare * loop.diagonal) continue;
    side.followedBy = share * offset.distance;
    setCurve(side.ribbon, movedCurve(side.ribbon, share, kFitShare * side.followedBy));
  }
  return followed;
}

}  // namespace fairing::boundary
