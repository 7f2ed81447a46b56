// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <functional>
#include <vector>

#include "core/spline/bspline_curve.h"

namespace fairing::spline {

struct CurvePoint {
  Eigen::Vector3d point, derivative;
};
using CurveFunction = std::function<CurvePoint(double t)>;

struct CurveFit {
  BsplineCurve curve;
  std::vector<double> spanErrors;  ///< largest distance |curve(t) - given(t)| in every span, mm
  [[nodiscard]] double error() const;
};

/// Least-squares B-spline on given knots to a curve on the same domain, its ends met in position
/// and derivative. Distances are taken at equal parameters, on points between those of the fit.
/// degree >= 3.
[[nodiscard]] CurveFit fitCurve(const CurveFunction& given, const KnotVector& knots);

/// The knots on which a fit of every given curve is within `tolerance` mm: spans over which any is
/// off are bisected until none is, or until there would be more than `maxPoles` control points. The
/// order of the curves is irrelevant.
[[nodiscard]] KnotVector knotsThatFit(const std::vector<CurveFunction>& given,
                                      KnotVector knots,
                                      double tolerance,
                                      int maxPoles);

}  // namespace fairing::spline
