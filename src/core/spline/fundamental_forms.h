// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>

#include "core/spline/bspline_surface.h"

namespace fairing::spline {

/// The partial derivatives of R from order one to three, one a column: R_u, R_v, R_uu, R_uv, R_vv,
/// R_uuu, R_uuv, R_uvv, R_vvv.
using ThirdOrderJet = Eigen::Matrix<double, 3, 9>;

/// Picked from partial derivatives up to order three along each direction.
[[nodiscard]] ThirdOrderJet thirdOrderJet(const Partials& partials);

/// A function of u and v at a point: its value and its first partial derivatives.
struct FirstOrderJet {
  double value = 0.0, u = 0.0, v = 0.0;
};

inline FirstOrderJet operator+(const FirstOrderJet& a, const FirstOrderJet& b) {
  return {a.value + b.value, a.u + b.u, a.v + b.v};
}
inline FirstOrderJet operator*(double s, const FirstOrderJet& a) {
  return {s * a.value, s * a.u, s * a.v};
}
inline FirstOrderJet operator*(const FirstOrderJet& a, const FirstOrderJet& b) {
  return {a.value * b.value, a.u * b.value + a.value * b.u, a.v * b.value + a.value * b.v};
}

/// Both fundamental forms with their first derivatives; everything that curvature and its first
/// derivatives depend on. The second form is taken against k = R_u x R_v, not of unit length, and
/// so is sqrt(E G - F^2) times the usual one; polynomial in the jet, hence defined wherever R is.
struct FundamentalForms {
  FirstOrderJet e, f, g;  ///< E = R_u.R_u, F = R_u.R_v, G = R_v.R_v
  FirstOrderJet l, m, n;  ///< k.R_uu, k.R_uv, k.R_vv
};

[[nodiscard]] FundamentalForms fundamentalForms(const ThirdOrderJet& jet);

/// The gradient with respect to the jet of a function of the forms whose derivatives with respect
/// to these are `slopes`: the chain rule, backwards.
[[nodiscard]] ThirdOrderJet pullBack(const ThirdOrderJet& jet, const FundamentalForms& slopes);

}  // namespace fairing::spline
