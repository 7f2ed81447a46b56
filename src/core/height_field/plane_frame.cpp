// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/plane_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/angle.h"

namespace fairing::height_field {
namespace {

using boundary::BoundaryLoop;
using boundary::BoundarySide;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kSamples = 48;  // a side
// The plane of the area vector is kept up to this steepness: it treats all of the loop alike.
constexpr double kGentle = 50.0;
// A loop whose area is below this share of its squared diagonal is a slit from everywhere.
constexpr double kLeastArea = 1e-3;

// A place of the loop and what leans there.
struct Leaning {
  int edge = 0;
  Vector3d point, tangent;
  bool hasNormal = false;
  Vector3d normal;
};

std::vector<Leaning> sample(const BoundaryLoop& loop) {
  std::vector<Leaning> places;
  for (const BoundarySide& side : loop.sides)
    for (int k = 0; k < kSamples; ++k) {
      const double t = static_cast<double>(k) / kSamples;
      const boundary::CurveSample curve = side.ribbon.curve(t);
      Leaning place{side.edge, curve.point, curve.derivative.normalized(), false, {}};
      if (side.isTangent()) {
        const boundary::SupportSample support = side.ribbon.support(t);
        place.hasNormal = !support.singular;
        place.normal = support.normal;
      }
      places.push_back(place);
    }
  return places;
}

Vector3d areaVector(const std::vector<Leaning>& places) {
  Vector3d sum = Vector3d::Zero();
  const Vector3d centre = places.front().point;
  for (std::size_t k = 0; k < places.size(); ++k)
    sum += (places[k].point - centre).cross(places[(k + 1) % places.size()].point - centre);
  return 0.5 * sum;
}

double steepnessOf(const Leaning& place, const Vector3d& up) {
  const double edge = std::asin(std::min(1.0, std::abs(place.tangent.dot(up)))) * kDegrees;
  if (!place.hasNormal) return edge;
  return std::max(edge, std::acos(std::clamp(place.normal.dot(up), -1.0, 1.0)) * kDegrees);
}

const Leaning& steepest(const std::vector<Leaning>& places, const Vector3d& up) {
  return *std::max_element(places.begin(), places.end(), [&](const Leaning& a, const Leaning& b) {
    return steepnessOf(a, up) < steepnessOf(b, up);
  });
}

// The middle of the narrowest cone that holds all normals: each round moves towards the one
// farthest off, by ever smaller steps [BadoiuClarkson2003].
Vector3d middleOfNormals(const std::vector<Leaning>& places, Vector3d middle) {
  constexpr int kRounds = 200;
  for (int round = 1; round <= kRounds; ++round) {
    const Leaning* farthest = nullptr;
    for (const Leaning& place : places)
      if (place.hasNormal &&
          (farthest == nullptr || place.normal.dot(middle) < farthest->normal.dot(middle)))
        farthest = &place;
    if (farthest == nullptr) return middle;
    middle = (middle + (farthest->normal - middle) / (round + 1.0)).normalized();
  }
  return middle;
}

Vector3d chooseNormal(const std::vector<Leaning>& places, const Vector3d& area) {
  const Vector3d up = area.normalized();
  const double own = steepnessOf(steepest(places, up), up);
  if (own <= kGentle) return up;
  const Vector3d middle = middleOfNormals(places, up);
  const bool runsRound = middle.dot(up) > 0.1;  // the loop still encloses an area there
  return runsRound && steepnessOf(steepest(places, middle), middle) < own ? middle : up;
}

struct Rectangle {
  Vector2d direction = Vector2d::UnitX(), middle = Vector2d::Zero();
  double along = 0.0, across = 0.0;
};

Rectangle rectangleAlong(const std::vector<Vector2d>& points, const Vector2d& direction) {
  const Vector2d across(-direction[1], direction[0]);
  Eigen::AlignedBox2d box;
  for (const Vector2d& p : points) box.extend(Vector2d(p.dot(direction), p.dot(across)));
  const Vector2d middle = box.center();
  return {direction, middle[0] * direction + middle[1] * across, box.sizes()[0], box.sizes()[1]};
}

// The smallest of the rectangles along chords of the loop; one side of the smallest of all lies
// along such a chord.
Rectangle smallestRectangle(const std::vector<Vector2d>& points) {
  Rectangle best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vector2d chord = points[(k + 1) % points.size()] - points[k];
    if (chord.norm() == 0.0) continue;
    const Rectangle tried = rectangleAlong(points, chord.normalized());
    // By more than rounding, so that of equal ones the first is taken wherever the loop lies.
    if (tried.along * tried.across >= least * (1.0 - 1e-9)) continue;
    least = tried.along * tried.across;
    best = tried;
  }
  if (best.across > best.along) {
    best.direction = Vector2d(-best.direction[1], best.direction[0]);
    std::swap(best.along, best.across);
  }
  return best;
}

}  // namespace

Steepness steepness(const BoundaryLoop& loop, const PlaneFrame& frame) {
  const std::vector<Leaning> places = sample(loop);
  const Leaning& worst = steepest(places, frame.axes.col(2));
  return {steepnessOf(worst, frame.axes.col(2)), worst.edge, worst.point};
}

Result<PlaneFrame> choosePlane(const BoundaryLoop& loop) {
  const std::vector<Leaning> places = sample(loop);
  const Vector3d area = areaVector(places);
  if (!(area.norm() > kLeastArea * loop.diagonal * loop.diagonal))
    return fail({.code = ErrorCode::LayoutUnfit, .detail = "trimmed"});
  PlaneFrame frame;
  const Vector3d up = chooseNormal(places, area);
  const Vector3d helper = up.unitOrthogonal();
  frame.origin = places.front().point;
  frame.axes << helper, up.cross(helper), up;
  std::vector<Vector2d> points;
  for (const Leaning& place : places) points.push_back(frame.coordinates(place.point).head<2>());
  const Rectangle box = smallestRectangle(points);
  frame.origin += frame.axes.leftCols<2>() * box.middle;
  const Vector3d u = frame.axes.leftCols<2>() * box.direction;
  frame.axes << u, up.cross(u), up;
  frame.unit = std::sqrt(area.dot(up));
  return frame;
}

}  // namespace fairing::height_field
