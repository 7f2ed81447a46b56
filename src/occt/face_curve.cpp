// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/face_curve.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include "core/base/bisect.h"
#include "core/spline/fit_curve.h"
#include "occt/to_geom.h"

namespace fairing::occt {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTrim = 1e-7;  // of the parameters
constexpr double kFit = 2e-8;   // mm: within what the kernel takes for one place
constexpr int kDegree = 5, kMostPoles = 200;
constexpr double kDifference = 1e-4;  // of the curve's parameter range
// A straight end goes on in steps of this share of the size, so many at most.
constexpr double kStepShare = 0.02;
constexpr int kMostSteps = 500;
constexpr int kHalvings = 30;  // of the step that leaves the face

// Points with derivatives by differences of second order, one-sided at the ends.
spline::CurveFunction withDerivatives(const std::function<Vector3d(double)>& pointAt) {
  return [pointAt](double t) {
    const double h = kDifference;
    const Vector3d point = pointAt(t);
    if (t - h < 0.0)
      return spline::CurvePoint{
          point, (-3.0 * point + 4.0 * pointAt(t + h) - pointAt(t + 2.0 * h)) / (2.0 * h)};
    if (t + h > 1.0)
      return spline::CurvePoint{
          point, (3.0 * point - 4.0 * pointAt(t - h) + pointAt(t - 2.0 * h)) / (2.0 * h)};
    return spline::CurvePoint{point, (pointAt(t + h) - pointAt(t - h)) / (2.0 * h)};
  };
}

spline::KnotVector knotsWith(const std::vector<boundary::CurveBreak>& breaks) {
  auto knots = spline::KnotVector::bezier(kDegree);
  for (const boundary::CurveBreak& b : breaks)
    for (int k = std::clamp(b.continuity, 0, kDegree); k < kDegree; ++k)
      knots = knots.withKnot(b.t);
  return knots;
}

TopoDS_Edge fitted(const spline::CurveFunction& given, const spline::KnotVector& start) {
  const auto knots = spline::knotsThatFit({given}, start, kFit, kMostPoles);
  spline::CurveFit fit = spline::fitCurve(given, knots);
  spline::Poles& poles = fit.curve.poles;
  if ((poles.row(0) - poles.bottomRows<1>()).norm() <= kFit)
    poles.bottomRows<1>() = poles.row(0).eval();
  BRepBuilderAPI_MakeEdge make(toCurve(fit.curve));
  if (!make.IsDone()) throw Standard_Failure("a curve on a face makes no edge");
  const TopoDS_Edge edge = make.Edge();
  BRep_Builder().UpdateEdge(edge, std::max(Precision::Confusion(), fit.error()));
  return edge;
}

}  // namespace

FaceDomain::FaceDomain(const TopoDS_Face& face)
    : surface_(face, false), trim_(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), kTrim) {}

SurfacePoint FaceDomain::at(const Vector2d& w) const {
  return evaluate(surface_, w.x(), w.y());
}

TopAbs_State FaceDomain::state(const Vector2d& w) const {
  return trim_.Perform(gp_Pnt2d(w.x(), w.y()), true);
}

TopoDS_Edge edgeThrough(const std::function<Vector3d(double)>& pointAt,
                        const std::vector<boundary::CurveBreak>& breaks) {
  return fitted(withDerivatives(pointAt), knotsWith(breaks));
}

std::optional<WayOut> straightOut(const FaceDomain& face,
                                  const Vector2d& end,
                                  const Vector2d& before,
                                  double size) {
  const Vector2d direction = end - before;
  const SurfacePoint start = face.at(end);
  const double speed = (direction.x() * start.su + direction.y() * start.sv).norm();
  const double length = kStepShare * size;
  const Vector2d step = direction * (length / speed);
  int steps = 1;
  while (face.isInside(end + steps * step)) {
    if (++steps > kMostSteps) return std::nullopt;
  }
  const double inside = bisect(
      steps - 1.0, steps, kHalvings, [&](double k) { return face.isInside(end + k * step); });
  const Vector2d way = (steps + 1) * step;
  const auto given = [&](double t) {
    const SurfacePoint p = face.at(end + t * way);
    return spline::CurvePoint{p.point, way.x() * p.su + way.y() * p.sv};
  };
  return WayOut{fitted(given, spline::KnotVector::bezier(kDegree)), inside * length};
}

}  // namespace fairing::occt
