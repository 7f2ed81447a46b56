// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <cmath>

namespace fairing::shape_energy {

/// A number with its first and second derivatives with respect to n variables; see Dual.
template <int n>
struct SecondDual {
  using Slope = Eigen::Array<double, n, 1>;
  /// The lower triangle of the symmetric matrix, column by column.
  using Curve = Eigen::Array<double, n*(n + 1) / 2, 1>;

  SecondDual(double v) : value(v), slope(Slope::Zero()), curve(Curve::Zero()) {}  // NOLINT
  SecondDual(double v, const Slope& s, const Curve& c) : value(v), slope(s), curve(c) {}
  /// The k-th variable.
  static SecondDual variable(double value, int k) {
    SecondDual made(value);
    made.slope[k] = 1.0;
    return made;
  }
  [[nodiscard]] Eigen::Matrix<double, n, n> curveMatrix() const {
    Eigen::Matrix<double, n, n> matrix;
    for (int j = 0, k = 0; j < n; ++j)
      for (int i = j; i < n; ++i, ++k) matrix(i, j) = matrix(j, i) = curve[k];
    return matrix;
  }

  friend SecondDual operator+(const SecondDual& a, const SecondDual& b) {
    return {a.value + b.value, a.slope + b.slope, a.curve + b.curve};
  }
  friend SecondDual operator-(const SecondDual& a, const SecondDual& b) {
    return {a.value - b.value, a.slope - b.slope, a.curve - b.curve};
  }
  friend SecondDual operator*(const SecondDual& a, const SecondDual& b) {
    SecondDual made{a.value * b.value,
                    b.value * a.slope + a.value * b.slope,
                    b.value * a.curve + a.value * b.curve};
    made.addProducts(a.slope, b.slope);
    return made;
  }
  friend SecondDual operator*(double s, const SecondDual& a) {
    return {s * a.value, s * a.slope, s * a.curve};
  }
  // q b = a:  q'' = (a'' - q b'' - q' b' - b' q') / b
  friend SecondDual operator/(const SecondDual& a, const SecondDual& b) {
    const double value = a.value / b.value;
    const Slope slope = (a.slope - value * b.slope) / b.value;
    SecondDual made{value, slope, (a.curve - value * b.curve) / b.value};
    made.addProducts((-1.0 / b.value) * slope, b.slope);
    return made;
  }
  // r r = a:  r'' = (a'' - 2 r' r') / (2 r)
  friend SecondDual sqrt(const SecondDual& a) {
    const double root = std::sqrt(a.value);
    const Slope slope = (0.5 / root) * a.slope;
    SecondDual made{root, slope, (0.5 / root) * a.curve};
    made.addProducts((-0.5 / root) * slope, slope);
    return made;
  }

  double value;
  Slope slope;
  Curve curve;

 private:
  // Adds  a b' + b a'.
  void addProducts(const Slope& a, const Slope& b) {
    for (int j = 0, k = 0; j < n; k += n - j, ++j)
      curve.segment(k, n - j) += b[j] * a.tail(n - j) + a[j] * b.tail(n - j);
  }
};

}  // namespace fairing::shape_energy
