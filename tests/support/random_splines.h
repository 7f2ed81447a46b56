// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <functional>
#include <random>

#include "core/spline/bspline_curve.h"
#include "core/spline/bspline_surface.h"

namespace fairing::testing {

using Random = std::mt19937;

/// Uniform in [low, high].
[[nodiscard]] double randomNumber(Random& random, double low = -1.0, double high = 1.0);
[[nodiscard]] Eigen::Vector3d randomVector(Random& random);
[[nodiscard]] Eigen::MatrixXd randomMatrix(Random& random, Eigen::Index rows, Eigen::Index columns);

/// Clamped knots over [0, 1] with uneven spans, inner knots repeated up to `mostRepeats` times.
[[nodiscard]] spline::KnotVector randomKnots(Random& random,
                                             int degree,
                                             int spans,
                                             int mostRepeats = 1);
/// Poles in [-1, 1]^3.
[[nodiscard]] spline::BsplineCurve randomCurve(Random& random, const spline::KnotVector& knots);
/// Poles near a level grid over the unit square, heights and places off it by up to `roughness`.
[[nodiscard]] spline::BsplineSurface randomSurface(Random& random,
                                                   const spline::KnotVector& u,
                                                   const spline::KnotVector& v,
                                                   double roughness = 0.2);

using PointFunction = std::function<Eigen::Vector3d(double u, double v)>;

/// The spline that takes a function's values at the Greville points: the function itself where the
/// knots can write it.
[[nodiscard]] spline::BsplineSurface interpolated(const PointFunction& function,
                                                  const spline::KnotVector& u,
                                                  const spline::KnotVector& v);

/// `count` parameters evenly spread over the knots' domain, ends included.
[[nodiscard]] std::vector<double> evenParameters(const spline::KnotVector& knots, int count);

}  // namespace fairing::testing
