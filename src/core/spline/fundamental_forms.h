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
template <class Scalar>
struct BasicFirstOrderJet {
  Scalar value = 0.0, u = 0.0, v = 0.0;
};
using FirstOrderJet = BasicFirstOrderJet<double>;

template <class Scalar>
BasicFirstOrderJet<Scalar> operator+(const BasicFirstOrderJet<Scalar>& a,
                                     const BasicFirstOrderJet<Scalar>& b) {
  return {a.value + b.value, a.u + b.u, a.v + b.v};
}
template <class Scalar>
BasicFirstOrderJet<Scalar> operator*(double s, const BasicFirstOrderJet<Scalar>& a) {
  return {s * a.value, s * a.u, s * a.v};
}
template <class Scalar>
BasicFirstOrderJet<Scalar> operator*(const BasicFirstOrderJet<Scalar>& a,
                                     const BasicFirstOrderJet<Scalar>& b) {
  return {a.value * b.value, a.u * b.value + a.value * b.u, a.v * b.value + a.value * b.v};
}

/// Both fundamental forms with their first derivatives; everything that curvature and its first
/// derivatives depend on. The second form is taken against k = R_u x R_v, not of unit length, and
/// so is sqrt(E G - F^2) times the usual one; polynomial in the jet, hence defined wherever R is.
template <class Scalar>
struct BasicFundamentalForms {
  BasicFirstOrderJet<Scalar> e, f, g;  ///< E = R_u.R_u, F = R_u.R_v, G = R_v.R_v
  BasicFirstOrderJet<Scalar> l, m, n;  ///< k.R_uu, k.R_uv, k.R_vv
};
using FundamentalForms = BasicFundamentalForms<double>;

[[nodiscard]] FundamentalForms fundamentalForms(const ThirdOrderJet& jet);

/// The gradient with respect to the jet of a function of the forms whose derivatives with respect
/// to these are `slopes`: the chain rule, backwards.
[[nodiscard]] ThirdOrderJet pullBack(const ThirdOrderJet& jet, const FundamentalForms& slopes);

/// How pullBack() changes when the jet moves along another one, the slopes being held: the second
/// derivatives of the forms, summed by the slopes, times `along`.
[[nodiscard]] ThirdOrderJet pullBackChange(const ThirdOrderJet& jet,
                                           const ThirdOrderJet& along,
                                           const FundamentalForms& slopes);

}  // namespace fairing::spline
