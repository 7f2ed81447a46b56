// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/arc_length.h"

#include <algorithm>
#include <cmath>

#include "core/spline/quadrature.h"

namespace fairing::boundary {
namespace {

constexpr std::size_t kLeastSteps = 48;
constexpr int kPoints = 4;  // of a Gauss-Legendre rule a step
constexpr int kNewtonSteps = 4;

// Where the speed may have a kink, and the ends.
std::vector<double> kinks(const Ribbon& ribbon, double from, double to) {
  std::vector<double> places{from};
  if (ribbon.polynomial)
    for (const double t : ribbon.polynomial->knots.breaks())
      if (from < t && t < to) places.push_back(t);
  for (const CurveBreak& b : ribbon.breaks)
    if (from < b.t && b.t < to) places.push_back(b.t);
  places.push_back(to);
  std::sort(places.begin(), places.end());
  return places;
}

// Cubic Hermite interpolation of the parameter over the length between two nodes.
double guess(double t0, double t1, double slope0, double slope1, double width, double share) {
  const double s = share, r = 1.0 - share;
  return r * r * (1.0 + 2.0 * s) * t0 + s * s * (1.0 + 2.0 * r) * t1 +
         width * s * r * (r * slope0 - s * slope1);
}

}  // namespace

ArcLength::ArcLength(const Ribbon& ribbon, double from, double to) : curve_(ribbon.curve) {
  const std::vector<double> places = kinks(ribbon, from, to);
  const std::size_t parts = 1 + kLeastSteps / (places.size() - 1);
  const auto add = [&](double t, double length) {
    nodes_.push_back({t, length, curve_(t).derivative.norm()});
  };
  add(from, 0.0);
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    for (std::size_t m = 1; m <= parts; ++m) {
      const double t = m == parts
                           ? places[k + 1]
                           : places[k] + (places[k + 1] - places[k]) * static_cast<double>(m) /
                                             static_cast<double>(parts);
      add(t, nodes_.back().length + between(nodes_.back().t, t));
    }
}

double ArcLength::between(double a, double b) const {
  static const auto rule = spline::gaussLegendre(kPoints, 0.0, 1.0);
  double sum = 0.0;
  for (const auto& q : rule) sum += q.weight * curve_(a + q.parameter * (b - a)).derivative.norm();
  return sum * (b - a);
}

double ArcLength::lengthUpTo(double t) const {
  const auto above = std::upper_bound(
      nodes_.begin() + 1, nodes_.end() - 1, t, [](double x, const Node& n) { return x < n.t; });
  const Node& low = *(above - 1);
  return low.length + between(low.t, t);
}

double ArcLength::parameterAt(double length) const {
  const auto above =
      std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, length, [](double x, const Node& n) {
        return x < n.length;
      });
  const Node &low = *(above - 1), &high = *above;
  const double width = high.length - low.length;
  if (!(width > 0.0) || !(low.speed > 0.0) || !(high.speed > 0.0)) return low.t;
  const double share = std::clamp((length - low.length) / width, 0.0, 1.0);
  double t = guess(low.t, high.t, 1.0 / low.speed, 1.0 / high.speed, width, share);
  for (int i = 0; i < kNewtonSteps; ++i) {
    const double off = low.length + between(low.t, t) - length;
    if (std::abs(off) <= 1e-13 * nodes_.back().length) break;
    t = std::clamp(t - off / curve_(t).derivative.norm(), low.t, high.t);
  }
  return t;
}

}  // namespace fairing::boundary
