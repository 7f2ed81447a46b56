// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <cmath>

namespace fairing::testing {

/// A value with its partial derivatives up to order two in two variables: formulas written once
/// give a surface with everything a ribbon needs, exact to rounding.
struct Jet2 {
  double value = 0.0, u = 0.0, v = 0.0, uu = 0.0, uv = 0.0, vv = 0.0;

  Jet2() = default;
  Jet2(double constant) : value(constant) {}  // NOLINT: numbers mix with jets in formulas
  Jet2(double f, double fu, double fv, double fuu, double fuv, double fvv)
      : value(f), u(fu), v(fv), uu(fuu), uv(fuv), vv(fvv) {}
  static Jet2 alongU(double u) { return {u, 1.0, 0.0, 0.0, 0.0, 0.0}; }
  static Jet2 alongV(double v) { return {v, 0.0, 1.0, 0.0, 0.0, 0.0}; }
};

inline Jet2 operator+(const Jet2& a, const Jet2& b) {
  return {a.value + b.value, a.u + b.u, a.v + b.v, a.uu + b.uu, a.uv + b.uv, a.vv + b.vv};
}

inline Jet2 operator*(const Jet2& a, const Jet2& b) {
  return {a.value * b.value,
          a.u * b.value + a.value * b.u,
          a.v * b.value + a.value * b.v,
          a.uu * b.value + 2.0 * a.u * b.u + a.value * b.uu,
          a.uv * b.value + a.u * b.v + a.v * b.u + a.value * b.uv,
          a.vv * b.value + 2.0 * a.v * b.v + a.value * b.vv};
}

inline Jet2 operator-(const Jet2& a) {
  return a * Jet2(-1.0);
}
inline Jet2 operator-(const Jet2& a, const Jet2& b) {
  return a + (-b);
}

/// f(a) from the values of f, f' and f'' there.
inline Jet2 chain(const Jet2& a, double f, double f1, double f2) {
  return {f,
          f1 * a.u,
          f1 * a.v,
          f2 * a.u * a.u + f1 * a.uu,
          f2 * a.u * a.v + f1 * a.uv,
          f2 * a.v * a.v + f1 * a.vv};
}

inline Jet2 sin(const Jet2& a) {
  return chain(a, std::sin(a.value), std::cos(a.value), -std::sin(a.value));
}
inline Jet2 cos(const Jet2& a) {
  return chain(a, std::cos(a.value), -std::sin(a.value), -std::cos(a.value));
}
inline Jet2 exp(const Jet2& a) {
  const double e = std::exp(a.value);
  return chain(a, e, e, e);
}
inline Jet2 sqrt(const Jet2& a) {
  const double r = std::sqrt(a.value);
  return chain(a, r, 0.5 / r, -0.25 / (r * a.value));
}

}  // namespace fairing::testing
