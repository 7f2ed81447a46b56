// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <utility>

namespace fairing::shape_energy {

/// A number with its derivatives with respect to n variables: forward automatic differentiation.
/// A formula written for any scalar type gives its derivatives when it is evaluated with these.
template <int n>
struct Dual {
  using Slope = Eigen::Array<double, n, 1>;

  Dual(double v) : value(v), slope(Slope::Zero()) {}  // NOLINT: constants mix with duals
  Dual(double v, Slope s) : value(v), slope(std::move(s)) {}
  /// The k-th variable.
  static Dual variable(double value, int k) {
    Dual made(value);
    made.slope[k] = 1.0;
    return made;
  }

  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.slope + b.slope};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.slope - b.slope};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, b.value * a.slope + a.value * b.slope};
  }
  friend Dual operator*(double s, const Dual& a) { return {s * a.value, s * a.slope}; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double value = a.value / b.value;
    return {value, (a.slope - value * b.slope) / b.value};
  }
  friend Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value);
    return {root, (0.5 / root) * a.slope};
  }

  double value;
  Slope slope;
};

}  // namespace fairing::shape_energy
