// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/quadrature.h"

#include <array>
#include <cmath>
#include <numbers>

namespace fairing::spline {
namespace {

// Value and derivative of the Legendre polynomial P_n, by its three-term recurrence.
struct Legendre {
  double value, derivative;
};

Legendre legendre(int n, double x) {
  double before = 1.0, value = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, n * (x * value - before) / (x * x - 1.0)};
}

// The rule on [-1, 1].
std::vector<QuadraturePoint> makeRule(int n) {
  if (n == 1) return {{0.0, 2.0}};
  std::vector<QuadraturePoint> points;
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));  // a close guess of root i
    for (int newton = 0; newton < 20; ++newton) {
      const Legendre p = legendre(n, x);
      const double step = p.value / p.derivative;
      x -= step;
      if (std::abs(step) < 1e-15) break;
    }
    const double slope = legendre(n, x).derivative;
    points.push_back({x, 2.0 / ((1.0 - x * x) * slope * slope)});
  }
  return points;
}

// The usual ones are made once.
std::vector<QuadraturePoint> rule(int n) {
  constexpr std::size_t kKept = 32;
  static const auto kRules = [] {
    std::array<std::vector<QuadraturePoint>, kKept> rules;
    for (std::size_t k = 1; k < kKept; ++k) rules[k] = makeRule(static_cast<int>(k));
    return rules;
  }();
  const auto k = static_cast<std::size_t>(n);
  return k < kKept ? kRules[k] : makeRule(n);
}

}  // namespace

QuadratureRule QuadratureRule::orPoints(int gaussPoints) const {
  if (points > 0) return *this;
  return {gaussPoints + (family == QuadratureFamily::Lobatto ? 1 : 0), family};
}

std::vector<QuadraturePoint> gaussLegendre(int n, double a, double b) {
  std::vector<QuadraturePoint> points = rule(n);
  for (QuadraturePoint& q : points)
    q = {0.5 * (a + b) + 0.5 * (b - a) * q.parameter, 0.5 * (b - a) * q.weight};
  return points;
}

// The inner points are the roots of P'_(n-1), weights 2 / (n (n - 1) P_(n-1)^2): Newton with
// (1 - x^2) P'' = 2 x P' - m (m + 1) P.
std::vector<QuadraturePoint> gaussLobatto(int n, double a, double b) {
  const int m = n - 1;
  std::vector<QuadraturePoint> points;
  for (int i = 0; i <= m; ++i) {
    double x = -std::cos(std::numbers::pi * i / m);  // exact at the ends, else a close guess
    for (int newton = 0; newton < 50 && i > 0 && i < m; ++newton) {
      const Legendre p = legendre(m, x);
      const double curve = (2.0 * x * p.derivative - m * (m + 1) * p.value) / (1.0 - x * x);
      const double step = p.derivative / curve;
      x -= step;
      if (std::abs(step) < 1e-15) break;
    }
    // P is 1 or -1 at the ends, where the recurrence's derivative is not defined.
    const double value = i > 0 && i < m ? legendre(m, x).value : 1.0;
    const double weight = 2.0 / (n * m * value * value);
    points.push_back({0.5 * (a + b) + 0.5 * (b - a) * x, 0.5 * (b - a) * weight});
  }
  return points;
}

std::vector<QuadraturePoint> gaussLegendre(int n, const KnotVector& knots) {
  return quadrature(n, knots);
}

std::vector<QuadraturePoint> quadrature(const QuadratureRule& rule, const KnotVector& knots) {
  const std::vector<QuadraturePoint> unit = rule.family == QuadratureFamily::Lobatto
                                                ? gaussLobatto(rule.points, 0.0, 1.0)
                                                : gaussLegendre(rule.points, 0.0, 1.0);
  const std::vector<double> breaks = knots.breaks();
  std::vector<QuadraturePoint> points;
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
    for (const QuadraturePoint& q : unit) {
      const double width = breaks[s + 1] - breaks[s];
      const double parameter = breaks[s] + width * q.parameter;
      points.push_back(
          {parameter < breaks[s + 1] ? parameter : std::nextafter(breaks[s + 1], breaks[s]),
           width * q.weight});
    }
  return points;
}

}  // namespace fairing::spline
