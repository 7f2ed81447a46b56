// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/edge_curve.h"

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "occt/from_occt.h"

namespace fairing::occt {
namespace {

/// A converted curve may differ by this share of its size; a parameter snapped to a knot shows up
/// here.
constexpr double kExact = 1e-12;
constexpr int kChecks = 23;

const double kNan = std::numeric_limits<double>::quiet_NaN();

spline::BsplineCurve straight(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  spline::BsplineCurve line{spline::KnotVector::bezier(1), spline::Poles(2, 3)};
  line.poles << start.transpose(), end.transpose();
  return line;
}

Handle(Geom_Curve) basisCurve(Handle(Geom_Curve) curve) {
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
    curve = trimmed->BasisCurve();
  return curve;
}

/// Weights that are all equal cancel out.
bool isPolynomial(const Geom_BSplineCurve& curve) {
  for (int i = 2; i <= curve.NbPoles(); ++i) {
    if (std::abs(curve.Weight(i) / curve.Weight(1) - 1.0) > 1e-15) return false;
  }
  return true;
}

/// Inner knots of full multiplicity go where the curve is C1 there all the same; false if one has
/// to stay.
bool makeC1(Geom_BSplineCurve& curve, double size) {
  for (int i = curve.LastUKnotIndex() - 1; i > curve.FirstUKnotIndex(); --i) {
    if (curve.Multiplicity(i) < curve.Degree()) continue;
    if (curve.Degree() < 2 || !curve.RemoveKnot(i, curve.Degree() - 1, kExact * size)) return false;
  }
  return true;
}

spline::BsplineCurve toCore(const Geom_BSplineCurve& curve) {
  std::vector<double> knots;
  const double first = curve.FirstParameter();
  const double range = curve.LastParameter() - first;
  for (int i = 1; i <= curve.NbKnots(); ++i) {
    const double knot = i == curve.NbKnots() ? 1.0 : (curve.Knot(i) - first) / range;
    knots.insert(knots.end(), static_cast<std::size_t>(curve.Multiplicity(i)), knot);
  }
  spline::BsplineCurve result{spline::KnotVector(curve.Degree(), std::move(knots)),
                              spline::Poles(curve.NbPoles(), 3)};
  for (int i = 1; i <= curve.NbPoles(); ++i) {
    result.poles.row(i - 1) = fromOcct(curve.Pole(i)).transpose();
  }
  return result;
}

bool isClamped(const Geom_BSplineCurve& curve) {
  return curve.Multiplicity(1) == curve.Degree() + 1 &&
         curve.Multiplicity(curve.NbKnots()) == curve.Degree() + 1;
}

/// The B-spline that carries the edge, cut to its range; null where the edge is no B-spline or
/// Bezier curve.
Handle(Geom_BSplineCurve) cutBspline(const TopoDS_Edge& edge) {
  double first, last;
  const Handle(Geom_Curve) curve = basisCurve(BRep_Tool::Curve(edge, first, last));
  Handle(Geom_BSplineCurve) spline;
  if (const auto own = Handle(Geom_BSplineCurve)::DownCast(curve)) {
    spline = Handle(Geom_BSplineCurve)::DownCast(own->Copy());
  } else if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(curve)) {
    spline = GeomConvert::CurveToBSplineCurve(bezier);
  }
  if (spline.IsNull()) return spline;
  // Files keep 15 digits: a range that should be the whole curve misses it by a rounding.
  const double rounding = kExact * (last - first);
  const bool whole = std::abs(first - spline->FirstParameter()) <= rounding &&
                     std::abs(last - spline->LastParameter()) <= rounding;
  if (!whole || spline->IsPeriodic() || !isClamped(*spline)) {
    // The default tolerance snaps to knots 1e-9 away, which the check below would notice.
    spline->Segment(first, last, 4.0 * std::numeric_limits<double>::epsilon() * (last - first));
  }
  return spline;
}

double sizeOf(const EdgeCurve& curve) {
  double size = 0.0;
  const Eigen::Vector3d origin = curve.point(0.0);
  for (int i = 1; i <= kChecks; ++i) {
    size = std::max(size, (curve.point(double(i) / kChecks) - origin).norm());
  }
  return size;
}

}  // namespace

EdgeCurve::EdgeCurve(const TopoDS_Edge& edge, Direction direction) : curve_(edge) {
  start_ = curve_.FirstParameter();
  end_ = curve_.LastParameter();
  if (direction == Direction::Backward) std::swap(start_, end_);
}

boundary::CurveSample EdgeCurve::at(double t) const {
  try {
    gp_Pnt p;
    gp_Vec d;
    curve_.D1(parameter(t), p, d);
    return {fromOcct(p), fromOcct(d) * (end_ - start_)};
  } catch (const Standard_Failure&) {
    return {Eigen::Vector3d::Constant(kNan), Eigen::Vector3d::Constant(kNan)};
  }
}

Eigen::Vector3d EdgeCurve::point(double t) const {
  return at(t).point;
}

bool EdgeCurve::isFinite() const {
  return !Precision::IsInfinite(start_) && !Precision::IsInfinite(end_);
}

std::optional<spline::BsplineCurve> polynomialCurve(const TopoDS_Edge& edge, Direction direction) {
  try {
    const EdgeCurve exact(edge, direction);
    if (!exact.isFinite()) return std::nullopt;
    double first, last;
    const Handle(Geom_Curve) curve = basisCurve(BRep_Tool::Curve(edge, first, last));
    if (curve.IsNull()) return std::nullopt;
    if (curve->IsKind(STANDARD_TYPE(Geom_Line)))
      return straight(exact.point(0.0), exact.point(1.0));

    const Handle(Geom_BSplineCurve) spline = cutBspline(edge);
    if (spline.IsNull() || !isPolynomial(*spline)) return std::nullopt;
    const double size = sizeOf(exact);
    if (!makeC1(*spline, size)) return std::nullopt;
    if (direction == Direction::Backward) spline->Reverse();
    const spline::BsplineCurve result = toCore(*spline);
    const double allowed = 10.0 * kExact * (size + exact.point(0.0).norm());
    for (int i = 0; i <= kChecks; ++i) {
      const double t = double(i) / kChecks;
      if (!((result.evaluate(t) - exact.point(t)).norm() <= allowed)) return std::nullopt;
    }
    return result;
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

std::vector<boundary::CurveBreak> curveBreaks(const TopoDS_Edge& edge, Direction direction) {
  std::vector<boundary::CurveBreak> breaks;
  try {
    const Handle(Geom_BSplineCurve) spline = cutBspline(edge);
    if (spline.IsNull()) return breaks;
    const double first = spline->FirstParameter();
    const double range = spline->LastParameter() - first;
    for (int i = spline->FirstUKnotIndex() + 1; i < spline->LastUKnotIndex(); ++i) {
      const double t = (spline->Knot(i) - first) / range;
      breaks.push_back({direction == Direction::Forward ? t : 1.0 - t,
                        spline->Degree() - spline->Multiplicity(i)});
    }
    if (direction == Direction::Backward) std::reverse(breaks.begin(), breaks.end());
  } catch (const Standard_Failure&) {
    breaks.clear();
  }
  return breaks;
}

}  // namespace fairing::occt
