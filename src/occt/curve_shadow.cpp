// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/curve_shadow.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>

#include "core/base/bisect.h"

namespace fairing::occt {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kGrid = 24;  // starts over the face, in either direction
constexpr int kHalvings = 40;
constexpr double kBeyond = 1e6;  // of a periodic surface's period: no border there

// Where a surface may be evaluated: a periodic one goes on round and round.
DomainBox domainOf(const BRepAdaptor_Surface& surface) {
  Vector2d low(surface.FirstUParameter(), surface.FirstVParameter());
  Vector2d high(surface.LastUParameter(), surface.LastVParameter());
  if (surface.IsUPeriodic()) low[0] = -kBeyond * surface.UPeriod(), high[0] = -low[0];
  if (surface.IsVPeriodic()) low[1] = -kBeyond * surface.VPeriod(), high[1] = -low[1];
  return {low, high};
}

double middleOf(double from, double to, int k) {
  return from + (k + 0.5) / kGrid * (to - from);
}

}  // namespace

CurveShadow::CurveShadow(const TopoDS_Edge& edge, const TopoDS_Face& face)
    : edge_(edge),
      curve_(edge, Direction::Forward),
      face_(face),
      domain_(domainOf(face_.surface())) {
  const std::vector<SurfacePoint> starts = grid(face);
  for (int k = 0; k <= kPlaces; ++k) {
    const Vector3d target = curve_.point(double(k) / kPlaces);
    const auto nearest = std::min_element(
        starts.begin(), starts.end(), [&](const SurfacePoint& a, const SurfacePoint& b) {
          return (a.point - target).squaredNorm() < (b.point - target).squaredNorm();
        });
    ShadowPoint best = below(target, *nearest);
    if (k > 0) {
      const ShadowPoint next = below(target, face_.at(samples_.back().w));
      if (next.distance <= best.distance) best = next;
    }
    samples_.push_back(best);
  }
}

std::vector<SurfacePoint> CurveShadow::grid(const TopoDS_Face& face) const {
  double u0, u1, v0, v1;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < kGrid; ++i)
    for (int j = 0; j < kGrid; ++j)
      points.push_back(face_.at({middleOf(u0, u1, i), middleOf(v0, v1, j)}));
  return points;
}

ShadowPoint CurveShadow::below(const Vector3d& target, const SurfacePoint& start) const {
  const SurfacePoint foot = footFrom(face_.surface(), target, start, domain_);
  const Vector3d residual = target - foot.point;
  const Vector2d w(foot.u, foot.v);
  // At the end of a surface the nearest point is no foot: the curve has left it there.
  const Vector3d tangential =
      foot.isRegular() ? Vector3d(residual - residual.dot(foot.cross()) /
                                                 foot.cross().squaredNorm() * foot.cross())
                       : residual;
  const bool isFoot = tangential.norm() <= Precision::Confusion();
  return {w, foot.point, residual.norm(), isFoot && face_.isInside(w)};
}

ShadowPoint CurveShadow::at(double t) const {
  const Vector3d target = curve_.point(t);
  const auto before = std::size_t(std::clamp(int(t * kPlaces), 0, kPlaces - 1));
  const ShadowPoint a = below(target, face_.at(samples_[before].w));
  const ShadowPoint b = below(target, face_.at(samples_[before + 1].w));
  return b.distance < a.distance ? b : a;
}

double CurveShadow::exitBetween(double inside, double outside) const {
  return bisect(inside, outside, kHalvings, [&](double t) { return at(t).onFace; });
}

ShadowRun CurveShadow::runRound(int sample) const {
  const auto share = [](int k) { return double(k) / kPlaces; };
  const auto onFace = [&](int k) { return samples_[std::size_t(k)].onFace; };
  int first = sample, last = sample;
  while (first > 0 && onFace(first - 1)) --first;
  while (last < kPlaces && onFace(last + 1)) ++last;
  return {first == 0 ? 0.0 : exitBetween(share(first), share(first - 1)),
          last == kPlaces ? 1.0 : exitBetween(share(last), share(last + 1))};
}

TopoDS_Edge CurveShadow::edgeOver(const ShadowRun& run) const {
  bool liesOnFace = true;
  for (int k = 0; k <= kPlaces; ++k) {
    const double t = run.from + (run.to - run.from) * k / kPlaces;
    liesOnFace = liesOnFace && at(t).distance <= Precision::Confusion();
  }
  double first, last;
  const Handle(Geom_Curve) own = BRep_Tool::Curve(edge_, first, last);
  if (liesOnFace && !own.IsNull()) {
    BRepBuilderAPI_MakeEdge make(own, curve_.parameter(run.from), curve_.parameter(run.to));
    if (make.IsDone()) return make.Edge();
  }
  std::vector<boundary::CurveBreak> breaks;
  for (const boundary::CurveBreak& b : curveBreaks(edge_, Direction::Forward))
    if (b.t > run.from && b.t < run.to)
      breaks.push_back({(b.t - run.from) / (run.to - run.from), b.continuity});
  return edgeThrough([&](double t) { return at(run.from + t * (run.to - run.from)).point; },
                     breaks);
}

}  // namespace fairing::occt
