// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/bspline_curve.h"

#include "core/base/assert.h"
#include "core/spline/bspline_basis.h"

namespace fairing::spline {
namespace {

using Arguments = std::vector<double>;

// The blossom of the polynomial piece on knot span `span`, at `degree` arguments: de Boor's
// triangle with another argument in every round. A pole of the curve on other knots is the blossom
// at that pole's inner knots. [PieglTiller1997] section 5; [Ramshaw1989].
Eigen::Vector3d blossom(const BsplineCurve& curve, int span, const Arguments& arguments) {
  const int p = curve.knots.degree();
  const auto& t = curve.knots.knots();
  Poles d = curve.poles.middleRows(span - p, p + 1);
  for (int r = 1; r <= p; ++r) {
    for (int j = p; j >= r; --j) {
      const double low = t[static_cast<std::size_t>(span - p + j)];
      const double high = t[static_cast<std::size_t>(span + 1 + j - r)];
      const double share = (arguments[static_cast<std::size_t>(r - 1)] - low) / (high - low);
      d.row(j) = (1.0 - share) * d.row(j - 1) + share * d.row(j);
    }
  }
  return d.row(p);
}

// The knots a pole of `knots` depends on: knots[i+1 .. i+degree].
Arguments innerKnots(const KnotVector& knots, int pole) {
  const auto begin = knots.knots().begin() + pole + 1;
  return {begin, begin + knots.degree()};
}

BsplineCurve raisedOnce(const BsplineCurve& curve) {
  BsplineCurve result{curve.knots.raised(1), {}};
  const int degree = result.knots.degree();
  result.poles.setZero(result.knots.poleCount(), 3);
  for (int i = 0; i < result.knots.poleCount(); ++i) {
    const Arguments all = innerKnots(result.knots, i);
    const int span = curve.knots.span(result.knots.knots()[static_cast<std::size_t>(i)]);
    for (int left = 0; left < degree; ++left) {
      Arguments some = all;
      some.erase(some.begin() + left);
      result.poles.row(i) += blossom(curve, span, some).transpose() / degree;
    }
  }
  return result;
}

}  // namespace

Eigen::Vector3d BsplineCurve::evaluate(double t, int derivative) const {
  const BasisRow row = basisRow(knots, t, derivative);
  return (row.values.row(derivative) * poles.middleRows(row.first, knots.degree() + 1)).transpose();
}

BsplineCurve reversed(const BsplineCurve& curve) {
  return {curve.knots.reversed(), curve.poles.colwise().reverse()};
}

BsplineCurve insertKnot(const BsplineCurve& curve, double t) {
  return refinedTo(curve, curve.knots.withKnot(t));
}

BsplineCurve refinedTo(const BsplineCurve& curve, const KnotVector& finer) {
  FAIRING_ASSERT(curve.knots.degree() == finer.degree());
  BsplineCurve result{finer, Poles(finer.poleCount(), 3)};
  for (int i = 0; i < finer.poleCount(); ++i) {
    const int span = curve.knots.span(finer.knots()[static_cast<std::size_t>(i)]);
    result.poles.row(i) = blossom(curve, span, innerKnots(finer, i)).transpose();
  }
  return result;
}

BsplineCurve raiseDegree(const BsplineCurve& curve, int times) {
  BsplineCurve result = curve;
  for (int k = 0; k < times; ++k) result = raisedOnce(result);
  return result;
}

BsplineCurve stretchOf(const BsplineCurve& curve, double from, double to) {
  const int p = curve.knots.degree();
  BsplineCurve stretch;
  std::vector<double> knots(static_cast<std::size_t>(p) + 1, from);
  for (const double t : curve.knots.knots())
    if (from < t && t < to) knots.push_back(t);
  knots.insert(knots.end(), static_cast<std::size_t>(p) + 1, to);
  stretch.knots = KnotVector(p, knots);
  stretch.poles.resize(stretch.knots.poleCount(), 3);
  for (int i = 0; i < stretch.knots.poleCount(); ++i) {
    const int span = curve.knots.span(knots[static_cast<std::size_t>(i)]);
    stretch.poles.row(i) = blossom(curve, span, innerKnots(stretch.knots, i)).transpose();
  }
  stretch.knots = stretch.knots.mapped(0.0, 1.0);
  return stretch;
}

}  // namespace fairing::spline
