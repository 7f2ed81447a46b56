// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/random_splines.h"

#include <Eigen/LU>

#include "core/spline/bspline_basis.h"

namespace fairing::testing {

using spline::BsplineCurve;
using spline::BsplineSurface;
using spline::KnotVector;

double randomNumber(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Eigen::Vector3d randomVector(Random& random) {
  const double x = randomNumber(random), y = randomNumber(random), z = randomNumber(random);
  return {x, y, z};
}

Eigen::MatrixXd randomMatrix(Random& random, Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return randomNumber(random); });
}

KnotVector randomKnots(Random& random, int degree, int spans, int mostRepeats) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  for (int s = 1; s < spans; ++s) {
    const double knot = (s + randomNumber(random, -0.3, 0.3)) / spans;
    const int repeats = std::uniform_int_distribution<int>(1, mostRepeats)(random);
    knots.insert(knots.end(), static_cast<std::size_t>(repeats), knot);
  }
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
  return {degree, std::move(knots)};
}

BsplineCurve randomCurve(Random& random, const KnotVector& knots) {
  BsplineCurve curve{knots, spline::Poles(knots.poleCount(), 3)};
  for (int i = 0; i < knots.poleCount(); ++i) curve.poles.row(i) = randomVector(random).transpose();
  return curve;
}

BsplineSurface randomSurface(Random& random,
                             const KnotVector& u,
                             const KnotVector& v,
                             double roughness) {
  BsplineSurface surface{u, v, spline::Poles(u.poleCount() * v.poleCount(), 3)};
  for (int i = 0; i < u.poleCount(); ++i)
    for (int j = 0; j < v.poleCount(); ++j)
      surface.poles.row(surface.index(i, j)) =
          (Eigen::Vector3d(u.greville(i), v.greville(j), 0.0) + roughness * randomVector(random))
              .transpose();
  return surface;
}

BsplineSurface interpolated(const PointFunction& function,
                            const KnotVector& u,
                            const KnotVector& v) {
  const Eigen::PartialPivLU<Eigen::MatrixXd> alongU(
      spline::collocationMatrix(u, u.grevilleAbscissae()));
  const Eigen::PartialPivLU<Eigen::MatrixXd> alongV(
      spline::collocationMatrix(v, v.grevilleAbscissae()));
  BsplineSurface surface{u, v, spline::Poles(u.poleCount() * v.poleCount(), 3)};
  for (int c = 0; c < 3; ++c) {
    Eigen::MatrixXd values(u.poleCount(), v.poleCount());
    for (int i = 0; i < u.poleCount(); ++i)
      for (int j = 0; j < v.poleCount(); ++j)
        values(i, j) = function(u.greville(i), v.greville(j))[c];
    const Eigen::MatrixXd half = alongU.solve(values);
    const Eigen::MatrixXd poles = alongV.solve(half.transpose()).transpose();
    for (int i = 0; i < u.poleCount(); ++i)
      for (int j = 0; j < v.poleCount(); ++j) surface.poles(surface.index(i, j), c) = poles(i, j);
  }
  return surface;
}

std::vector<double> evenParameters(const KnotVector& knots, int count) {
  std::vector<double> result;
  for (int k = 0; k < count; ++k)
    result.push_back(knots.first() + (knots.last() - knots.first()) * k / (count - 1));
  return result;
}

}  // namespace fairing::testing
