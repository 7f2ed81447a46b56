// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/loop_probe.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fairing::analysis {
namespace {

// Edges that meet at a larger angle (degrees) continue each other: there is no corner to allow for.
constexpr double kSmoothJoint = 179.5;

// Arc length over the parameter, by trapezoids; of a closed curve from any place on.
class ArcLength {
 public:
  ArcLength(const boundary::Ribbon& ribbon, double start) : start_(start) {
    double speed = ribbon.curve(start).derivative.norm();
    for (int k = 1; k <= kSteps; ++k) {
      const double next = ribbon.curve(wrapped(static_cast<double>(k) / kSteps)).derivative.norm();
      lengths_.push_back(lengths_.back() + 0.5 * (speed + next) / kSteps);
      speed = next;
    }
  }
  /// The parameter where `share` of the length is behind.
  [[nodiscard]] double parameterAt(double share) const {
    const double length = share * lengths_.back();
    const auto above = std::upper_bound(lengths_.begin(), lengths_.end() - 1, length);
    const auto k = static_cast<std::size_t>(above - lengths_.begin());
    const double step = lengths_[k] - lengths_[k - 1];
    const double within = step > 0.0 ? (length - lengths_[k - 1]) / step : 0.5;
    return wrapped((static_cast<double>(k - 1) + within) / kSteps);
  }

 private:
  [[nodiscard]] double wrapped(double step) const {
    const double t = start_ + step;
    return t > 1.0 ? t - 1.0 : t;
  }
  static constexpr int kSteps = 64;
  double start_;
  std::vector<double> lengths_{0.0};
};

ProbePoint probe(const boundary::Ribbon& ribbon,
                 const boundary::Ribbon& target,
                 double t,
                 bool inCorner) {
  const boundary::CurveSample curve = ribbon.curve(t);
  ProbePoint p;
  p.t = t;
  p.inCorner = inCorner;
  p.point = curve.point;
  p.tangent = curve.derivative.normalized();
  if (!ribbon.hasSupport() || t == 0.0 || t == 1.0) return p;
  const boundary::SupportSample support = ribbon.support(t);
  p.hasNormal = !support.singular;
  if (!p.hasNormal) return p;
  p.normal = support.normal;
  p.iso = support.iso;
  const Eigen::Vector3d across = p.normal.cross(p.tangent).normalized();
  p.curvature = across.dot(support.secondForm * across);
  const Eigen::Vector3d along = target.curve(t).derivative.normalized();
  p.floor = std::asin(std::min(1.0, std::abs(p.normal.dot(along)))) * 180.0 / std::numbers::pi;
  return p;
}

std::vector<ProbePoint> probeSide(const boundary::Ribbon& ribbon,
                                  const boundary::Ribbon& target,
                                  bool startsInCorner,
                                  bool endsInCorner,
                                  double start,
                                  const Places& places) {
  const auto& [inside, corner] = places;
  const ArcLength length(ribbon, start);
  std::vector<ProbePoint> points{probe(ribbon, target, 0.0, true)};
  const auto add = [&](double share, bool inCorner) {
    points.push_back(probe(ribbon, target, length.parameterAt(share), inCorner));
  };
  for (int k = 0; k < corner; ++k) add(kCornerZone * (k + 0.5) / corner, startsInCorner);
  for (int k = 0; k < inside; ++k)
    add(kCornerZone + (1.0 - 2.0 * kCornerZone) * (k + 0.5) / inside, false);
  for (int k = 0; k < corner; ++k)
    add(1.0 - kCornerZone * (corner - k - 0.5) / corner, endsInCorner);
  points.push_back(probe(ribbon, target, 1.0, true));
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  return points;
}

}  // namespace

LoopProbe probeLoop(const boundary::BoundaryLoop& loop,
                    const boundary::BoundaryLoop& target,
                    const std::vector<double>& starts,
                    const Places& places) {
  LoopProbe probe;
  const auto isCorner = [&](std::size_t k) { return loop.corners[k].angle < kSmoothJoint; };
  for (std::size_t k = 0; k < loop.sides.size(); ++k)
    probe.sides.push_back(probeSide(loop.sides[k].ribbon,
                                    target.sides[k].ribbon,
                                    isCorner(loop.previous(k)),
                                    isCorner(k),
                                    starts.empty() ? 0.0 : starts[k],
                                    places));
  return probe;
}

}  // namespace fairing::analysis
