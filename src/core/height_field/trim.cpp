// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/trim.h"

#include "core/spline/fit_curve.h"

namespace fairing::height_field {
namespace {

constexpr int kDegree = 5, kMostPoles = 200;

spline::BsplineCurve curveOf(const boundary::Ribbon& ribbon, double fitTolerance) {
  if (ribbon.polynomial) return *ribbon.polynomial;
  std::vector<double> breaks{0.0};
  for (const boundary::CurveBreak& at : ribbon.breaks) breaks.push_back(at.t);
  breaks.push_back(1.0);
  const auto start = spline::KnotVector::fromBreaks(kDegree, breaks, 3);
  const auto knots = spline::knotsThatFit({ribbon.curve}, start, fitTolerance, kMostPoles);
  return spline::fitCurve(ribbon.curve, knots).curve;
}

}  // namespace

Trim trimBy(const boundary::BoundaryLoop& loop, const PlaneFrame& frame, double fitTolerance) {
  Trim trim;
  for (const boundary::BoundarySide& side : loop.sides) {
    TrimCurve curve{side.edge, curveOf(side.ribbon, fitTolerance), {}};
    // Projecting is affine: the poles are projected.
    curve.parameters.resize(curve.inSpace.poles.rows(), 2);
    for (Eigen::Index k = 0; k < curve.parameters.rows(); ++k)
      curve.parameters.row(k) =
          frame.coordinates(curve.inSpace.poles.row(k).transpose()).head<2>().transpose();
    trim.curves.push_back(std::move(curve));
  }
  return trim;
}

}  // namespace fairing::height_field
