// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/fit_curve.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/spline/bspline_basis.h"
#include "core/spline/quadrature.h"

namespace fairing::spline {
namespace {

// Spans much better than the worst one wait: their error may be its doing.
constexpr double kWorthShare = 0.05;
// Spans shorter than this share of the curve are not bisected: what is left there is a kink.
constexpr double kShortestSpan = 2e-3;

// The two poles at either end, from end point and end derivative.
void setEnds(const CurveFunction& given, BsplineCurve& curve) {
  const KnotVector& k = curve.knots;
  const int n = k.poleCount(), p = k.degree();
  const auto& t = k.knots();
  const CurvePoint a = given(k.first()), b = given(k.last());
  const double firstStep = (t[static_cast<std::size_t>(p) + 1] - k.first()) / p;
  const double lastStep = (k.last() - t[static_cast<std::size_t>(n) - 1]) / p;
  curve.poles.row(0) = a.point.transpose();
  curve.poles.row(1) = (a.point + firstStep * a.derivative).transpose();
  curve.poles.row(n - 2) = (b.point - lastStep * b.derivative).transpose();
  curve.poles.row(n - 1) = b.point.transpose();
}

}  // namespace

double CurveFit::error() const {
  return spanErrors.empty() ? 0.0 : *std::max_element(spanErrors.begin(), spanErrors.end());
}

CurveFit fitCurve(const CurveFunction& given, const KnotVector& knots) {
  FAIRING_ASSERT(knots.degree() >= 3);
  const int n = knots.poleCount();
  CurveFit fit{{knots, Poles::Zero(n, 3)}, {}};
  setEnds(given, fit.curve);
  const int inner = n - 4;
  if (inner > 0) {
    // Normal equations of the inner poles; small and well conditioned for least squares on Gauss
    // points.
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
    Poles right = Poles::Zero(n, 3);
    for (const QuadraturePoint& q : gaussLegendre(knots.degree() + 1, knots)) {
      const BasisRow row = basisRow(knots, q.parameter);
      const Eigen::Vector3d rest = given(q.parameter).point;
      const auto b = row.values.row(0);
      const int width = knots.degree() + 1;
      normal.block(row.first, row.first, width, width) += q.weight * b.transpose() * b;
      right.middleRows(row.first, width) += q.weight * b.transpose() * rest.transpose();
    }
    right -= normal * fit.curve.poles;  // the ends are known
    fit.curve.poles.middleRows(2, inner) =
        normal.block(2, 2, inner, inner).llt().solve(right.middleRows(2, inner));
  }
  const std::vector<double> breaks = knots.breaks();
  const int checks = knots.degree() + 2;
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    double worst = 0.0;
    for (int k = 0; k < checks; ++k) {
      const double t = breaks[s] + (breaks[s + 1] - breaks[s]) * (k + 0.5) / checks;
      worst = std::max(worst, (fit.curve.evaluate(t) - given(t).point).norm());
    }
    fit.spanErrors.push_back(worst);
  }
  return fit;
}

KnotVector knotsThatFit(const std::vector<CurveFunction>& given,
                        KnotVector knots,
                        double tolerance,
                        int maxPoles) {
  while (true) {
    const std::vector<double> breaks = knots.breaks();
    std::vector<double> errors(breaks.size() - 1, 0.0);
    for (const CurveFunction& curve : given) {
      const std::vector<double> own = fitCurve(curve, knots).spanErrors;
      for (std::size_t s = 0; s < errors.size(); ++s) errors[s] = std::max(errors[s], own[s]);
    }
    KnotVector finer = knots;
    const double shortest = kShortestSpan * (knots.last() - knots.first());
    const double worth =
        std::max(tolerance, kWorthShare * *std::max_element(errors.begin(), errors.end()));
    for (std::size_t s = 0; s < errors.size(); ++s)
      if (errors[s] > worth && breaks[s + 1] - breaks[s] > shortest)
        finer = finer.withKnot(0.5 * (breaks[s] + breaks[s + 1]));
    if (finer == knots || finer.poleCount() > maxPoles) return knots;
    knots = std::move(finer);
  }
}

}  // namespace fairing::spline
