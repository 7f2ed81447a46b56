// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/spline/knot_vector.h"

namespace fairing::spline {

struct QuadraturePoint {
  double parameter;
  double weight;
};

enum class QuadratureFamily {
  Gauss,    ///< Gauss-Legendre: no point on a span's ends
  Lobatto,  ///< Gauss-Lobatto: the ends are points, the order is two less
};

/// A rule for every span; `points` a span and direction, 0 = left to who uses it.
struct QuadratureRule {
  QuadratureRule(int ofPoints = 0, QuadratureFamily ofFamily = QuadratureFamily::Gauss)  // NOLINT
      : points(ofPoints), family(ofFamily) {}
  /// The same, where its number of points was left open as good as so many Gauss points: Lobatto's
  /// order is that of one less.
  [[nodiscard]] QuadratureRule orPoints(int gaussPoints) const;

  int points;
  QuadratureFamily family;
};

/// Gauss-Legendre on [a, b] with n >= 1 points: exact for polynomials of degree 2n - 1.
[[nodiscard]] std::vector<QuadraturePoint> gaussLegendre(int n, double a, double b);

/// Gauss-Legendre with n points on every span of the knots.
[[nodiscard]] std::vector<QuadraturePoint> gaussLegendre(int n, const KnotVector& knots);

/// Gauss-Lobatto on [a, b] with n >= 2 points, both ends among them: exact for polynomials of
/// degree 2n - 3.
[[nodiscard]] std::vector<QuadraturePoint> gaussLobatto(int n, double a, double b);

/// A rule with its number of points on every span of the knots. The end of a span, which basis
/// functions take for the start of the next, is the number before it.
[[nodiscard]] std::vector<QuadraturePoint> quadrature(const QuadratureRule& rule,
                                                      const KnotVector& knots);

}  // namespace fairing::spline
