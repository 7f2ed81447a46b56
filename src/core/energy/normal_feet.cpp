// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/normal_feet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairing::energy {
namespace {

using Eigen::Vector3d;

// Normals of several guides whose mean is shorter than this cancel each other.
constexpr double kCancelled = 1e-3;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Smooth, and nothing beyond the radius.
double fade(double squaredDistance, double radius) {
  const double x = squaredDistance / (radius * radius);
  return x < 1.0 ? (1.0 - x) * (1.0 - x) : 0.0;
}

// How far a point is from the line along the patch's normal through its foot: 0 above the inside
// of a patch.
double beside(const Vector3d& point, const spline::SurfaceFoot& foot) {
  const Vector3d away = point - foot.jet.point, normal = foot.jet.normalVector();
  if (!(normal.norm() > 0.0)) return away.norm();
  const Vector3d unit = normal.normalized();
  return (away - away.dot(unit) * unit).norm();
}

struct NearFoot {
  double squaredDistance = kInfinity;
  Vector3d normal = Vector3d::Zero();
};

// The nearest place on the chain of feet, with the normal between those of its ends.
NearFoot nearestOn(const std::vector<Vector3d>& feet,
                   const std::vector<Vector3d>& normals,
                   const Vector3d& point) {
  if (feet.empty()) return {};
  NearFoot best{(point - feet[0]).squaredNorm(), normals[0]};
  for (std::size_t k = 1; k < feet.size(); ++k) {
    const Vector3d along = feet[k] - feet[k - 1];
    const double length = along.squaredNorm();
    const double share =
        length > 0.0 ? std::clamp((point - feet[k - 1]).dot(along) / length, 0.0, 1.0) : 0.0;
    const double distance = (point - feet[k - 1] - share * along).squaredNorm();
    if (distance < best.squaredDistance)
      best = {distance, (1.0 - share) * normals[k - 1] + share * normals[k]};
  }
  return best;
}

}  // namespace

NormalFeet::NormalFeet(const Guidance& guidance,
                       const std::vector<spline::BsplineSurface>& patches) {
  if (!guidance.hasNormals()) return;
  const spline::NearestPatch nearest(patches);
  int number = 0;
  for (const NormalHandle& h : guidance.handles)
    add(nearest, {h.point}, {h.normal}, {{}, {}, h.weight, h.radius, {h.point, false, ++number}});
  number = 0;
  for (const NormalCurve& c : guidance.curves)
    add(nearest, c.points, c.normals, {{}, {}, c.weight, c.radius, {c.points[0], true, ++number}});
}

// Points beside the patches have no foot.
void NormalFeet::add(const spline::NearestPatch& nearest,
                     const std::vector<Vector3d>& points,
                     const std::vector<Vector3d>& normals,
                     Source source) {
  if (!(source.weight > 0.0)) return;
  source.self.distance = kInfinity;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const spline::SurfaceFoot foot = nearest.to(points[k]).foot;
    const double off = beside(points[k], foot);
    source.self.distance = std::min(source.self.distance, off);
    if (off >= source.radius) continue;
    Vector3d normal = normals[k].normalized();
    if (!source.normals.empty() && normal.dot(source.normals.back()) < 0.0) normal = -normal;
    source.feet.push_back(foot.jet.point);
    source.normals.push_back(normal);
  }
  sources_.push_back(std::move(source));
}

std::optional<IdleGuide> NormalFeet::idle(const std::vector<Vector3d>& points) const {
  for (const Source& source : sources_) {
    if (source.feet.empty()) return source.self;
    double nearest = kInfinity;
    for (const Vector3d& point : points)
      nearest = std::min(nearest, nearestOn(source.feet, source.normals, point).squaredDistance);
    IdleGuide self = source.self;
    self.distance = std::sqrt(nearest);
    if (self.distance >= source.radius) return self;
  }
  return std::nullopt;
}

GuidanceSample NormalFeet::at(const Vector3d& point) const {
  GuidanceSample sample;
  sample.point = point;
  // fades f_i, weights w_i:  lambda = (sum f_i w_i / sum f_i) (1 - product (1 - f_i))
  double fades = 0.0, weights = 0.0, none = 1.0;
  Vector3d sum = Vector3d::Zero();
  for (const Source& source : sources_) {
    const NearFoot near = nearestOn(source.feet, source.normals, point);
    const double share = fade(near.squaredDistance, source.radius);
    if (!(share > 0.0) || !(near.normal.norm() > 0.0)) continue;
    const double weight = share * source.weight;
    const Vector3d normal = near.normal.normalized();
    sum += (sum.dot(normal) < 0.0 ? -weight : weight) * normal;
    fades += share;
    weights += weight;
    none *= 1.0 - share;
  }
  if (!(sum.norm() > kCancelled * weights)) return sample;
  sample.normal = sum.normalized();
  sample.lambda = weights / fades * (1.0 - none);
  return sample;
}

}  // namespace fairing::energy
