// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/known_loops.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fairing::testing {

using boundary::BoundarySide;
using boundary::CurveSample;
using boundary::Ribbon;
using boundary::SupportSample;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

BoundarySide numbered(Ribbon ribbon, int index) {
  BoundarySide side;
  side.edge = side.face = index + 1;
  side.ribbon = std::move(ribbon);
  return side;
}

spline::BsplineCurve polesAlong(const spline::BsplineSurface& s, int side) {
  const bool alongU = side % 2 == 0;
  const int nu = s.u.poleCount(), nv = s.v.poleCount();
  spline::BsplineCurve curve{alongU ? s.u : s.v, spline::Poles(alongU ? nu : nv, 3)};
  const int across = side == 1 ? nu - 1 : side == 2 ? nv - 1 : 0;
  for (int k = 0; k < curve.knots.poleCount(); ++k)
    curve.poles.row(k) = (alongU ? s.pole(k, across) : s.pole(across, k)).transpose();
  return side >= 2 ? spline::reversed(curve) : curve;
}

Ribbon reversedRibbon(const Ribbon& given) {
  Ribbon ribbon;
  ribbon.curve = [given](double t) {
    const CurveSample s = given.curve(1.0 - t);
    return CurveSample{s.point, -s.derivative};
  };
  if (given.polynomial) ribbon.polynomial = spline::reversed(*given.polynomial);
  for (auto at = given.breaks.rbegin(); at != given.breaks.rend(); ++at)
    ribbon.breaks.push_back({1.0 - at->t, at->continuity});
  if (given.hasSupport())
    ribbon.support = [given](double t) {
      SupportSample s = given.support(1.0 - t);
      s.normal = -s.normal;
      s.secondForm = -s.secondForm;
      return s;
    };
  return ribbon;
}

Ribbon movedRibbon(const Ribbon& given, const Eigen::Affine3d& similarity) {
  const double scale = std::cbrt(similarity.linear().determinant());
  const Eigen::Matrix3d rotation = similarity.linear() / scale;
  Ribbon ribbon;
  ribbon.curve = [given, similarity](double t) {
    const CurveSample s = given.curve(t);
    return CurveSample{similarity * s.point, similarity.linear() * s.derivative};
  };
  ribbon.breaks = given.breaks;
  if (given.polynomial) {
    ribbon.polynomial = given.polynomial;
    for (auto row : ribbon.polynomial->poles.rowwise())
      row = (similarity * Vector3d(row.transpose())).transpose();
  }
  if (given.hasSupport())
    ribbon.support = [given, similarity, rotation, scale](double t) {
      SupportSample s = given.support(t);
      s.point = similarity * s.point;
      s.normal = rotation * s.normal;
      s.secondForm = rotation * s.secondForm * rotation.transpose() / scale;
      return s;
    };
  return ribbon;
}

}  // namespace

Trace line(const Vector2d& from, const Vector2d& to) {
  return [from, to](double t) { return TracePoint{from + t * (to - from), to - from}; };
}

Trace bow(const Vector2d& from, const Vector2d& to, double bulge) {
  const Vector2d sideways(to[1] - from[1], from[0] - to[0]);
  return [=](double t) {
    return TracePoint{from + t * (to - from) + 4.0 * bulge * t * (1.0 - t) * sideways,
                      to - from + 4.0 * bulge * (1.0 - 2.0 * t) * sideways};
  };
}

BoundarySide sideOn(const KnownSurface& surface, const Trace& trace, int index) {
  Ribbon ribbon;
  ribbon.curve = [surface, trace](double t) {
    const TracePoint at = trace(t);
    const spline::SurfaceJet jet = surface(at.point[0], at.point[1]);
    return CurveSample{jet.point, jet.u * at.derivative[0] + jet.v * at.derivative[1]};
  };
  ribbon.support = [surface, trace](double t) {
    const TracePoint at = trace(t);
    const spline::SurfaceJet jet = surface(at.point[0], at.point[1]);
    return SupportSample{jet.point, normalOf(jet), secondFormOf(jet)};
  };
  return numbered(std::move(ribbon), index);
}

Sides sidesOf(const KnownSurface& surface, const std::array<Vector2d, 4>& corners, double bulge) {
  Sides sides;
  for (std::size_t k = 0; k < 4; ++k)
    sides.push_back(
        sideOn(surface, bow(corners[k], corners[(k + 1) % 4], bulge), static_cast<int>(k)));
  return sides;
}

boundary::BoundaryLoop loopOf(const KnownSurface& surface,
                              const std::array<Vector2d, 4>& corners,
                              double bulge) {
  return finished(sidesOf(surface, corners, bulge));
}

std::array<Vector2d, 4> rectangle(double u0, double u1, double v0, double v1) {
  return {Vector2d(u0, v0), Vector2d(u1, v0), Vector2d(u1, v1), Vector2d(u0, v1)};
}

std::array<Vector2d, 4> unitSquare() {
  return rectangle(0.0, 1.0, 0.0, 1.0);
}

std::array<Vector2d, 4> unevenQuadrilateral() {
  return {Vector2d(0.0, 0.0), Vector2d(1.3, 0.1), Vector2d(1.1, 0.9), Vector2d(-0.1, 1.2)};
}

Sides borderOf(const spline::BsplineSurface& surface) {
  const std::array<Vector2d, 4> corners = unitSquare();
  Sides sides;
  for (int k = 0; k < 4; ++k) {
    const auto here = static_cast<std::size_t>(k);
    sides.push_back(sideOn(surfaceOf(surface), line(corners[here], corners[(here + 1) % 4]), k));
    sides.back().ribbon.polynomial = polesAlong(surface, k);
  }
  return sides;
}

Sides incompatibleTwists(double turn) {
  const std::array<Vector2d, 4> corners = unitSquare();
  Sides sides;
  for (std::size_t k = 0; k < 4; ++k) {
    sides.push_back(sideOn(plane(), line(corners[k], corners[(k + 1) % 4]), static_cast<int>(k)));
    Ribbon& ribbon = sides.back().ribbon;
    ribbon.support = [flat = ribbon.support, curve = ribbon.curve, turn](double t) {
      // A double zero at t = 1 and a simple one at t = 0: level at both corners, twisted at one.
      const double angle = turn * t * (1.0 - t) * (1.0 - t);
      SupportSample s = flat(t);
      s.normal = Eigen::AngleAxisd(angle, curve(t).derivative.normalized()) * s.normal;
      return s;
    };
  }
  return sides;
}

boundary::BoundaryLoop finished(Sides sides) {
  auto loop = boundary::makeLoop(std::move(sides));
  if (!loop) throw std::logic_error("the sides of a test form no loop");
  return std::move(*loop);
}

Sides moved(const Sides& sides, const Eigen::Affine3d& similarity) {
  Sides result = sides;
  for (BoundarySide& side : result) side.ribbon = movedRibbon(side.ribbon, similarity);
  return result;
}

Sides startingAt(const Sides& sides, std::size_t first) {
  Sides result = sides;
  std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(first), result.end());
  return result;
}

Sides turnedRound(const Sides& sides) {
  Sides result(sides.rbegin(), sides.rend());
  for (BoundarySide& side : result) side.ribbon = reversedRibbon(side.ribbon);
  return result;
}

}  // namespace fairing::testing
