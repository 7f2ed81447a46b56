// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/shape_energy/mean_curvature_gradient.h"

#include <array>
#include <cmath>

#include "core/shape_energy/form_variables.h"
#include "core/spline/fundamental_forms.h"

// With D = E G - F^2 = W^2 and q = E n - 2 F m + G l (second form against R_u x R_v):
//   H = q / (2 W^3),   H_u = a / (4 D^(5/2)),   a = 2 q_u D - 3 q D_u,   b the same along v.
// The inverse square root of the first form is [G + W, -F; -F, E + W] / (s W), s^2 = E + G + 2 W;
// applied to (H_u, H_v) and times the root of the area element W it gives the residuals
//   r1 = c [(G + W) a - F b],   r2 = c [(E + W) b - F a],   c = 1 / (4 s D^(11/4)).

namespace fairing::shape_energy {
namespace {

using spline::BasicFirstOrderJet;
using spline::BasicFundamentalForms;
using spline::FirstOrderJet;
using spline::FundamentalForms;
using std::sqrt;

template <class T>
struct Terms {
  explicit Terms(const BasicFundamentalForms<T>& forms)
      : d(forms.e * forms.g + (-1.0) * (forms.f * forms.f)),
        q(forms.e * forms.n + (-2.0) * (forms.f * forms.m) + forms.g * forms.l),
        a(2.0 * q.u * d.value - 3.0 * q.value * d.u),
        b(2.0 * q.v * d.value - 3.0 * q.value * d.v),
        w(sqrt(d.value)),
        s2(forms.e.value + forms.g.value + 2.0 * w),
        c(1.0 / (4.0 * sqrt(s2 * w) * d.value * d.value * w)) {}

  BasicFirstOrderJet<T> d, q;
  T a, b, w, s2, c;
};

template <class T>
std::array<T, 2> values(const BasicFundamentalForms<T>& forms, const Terms<T>& t) {
  const T &e = forms.e.value, &f = forms.f.value, &g = forms.g.value;
  return {t.c * ((g + t.w) * t.a - f * t.b), t.c * ((e + t.w) * t.b - f * t.a)};
}

// A residual and its derivatives where E, F, G, W, a and b stand by themselves in the bracket.
struct Explicit {
  double value;
  double e, f, g, w, a, b;
};

// The slopes of x in a product x y, given those of the product.
FirstOrderJet through(const FirstOrderJet& slopes, const FirstOrderJet& y) {
  return {slopes.value * y.value + slopes.u * y.u + slopes.v * y.v,
          slopes.u * y.value,
          slopes.v * y.value};
}

FundamentalForms slopesOf(const FundamentalForms& forms,
                          const Terms<double>& t,
                          const Explicit& r) {
  const double c = r.value / t.s2;  // -2 dr/ds^2
  const double w = r.w - c;
  const FirstOrderJet q{
      -3.0 * (r.a * t.d.u + r.b * t.d.v), 2.0 * r.a * t.d.value, 2.0 * r.b * t.d.value};
  const FirstOrderJet d{
      2.0 * (r.a * t.q.u + r.b * t.q.v) - 2.75 * r.value / t.d.value + 0.5 * w / t.w,
      -3.0 * r.a * t.q.value,
      -3.0 * r.b * t.q.value};
  FundamentalForms s;
  s.e = through(q, forms.n) + through(d, forms.g);
  s.f = (-2.0) * (through(q, forms.m) + through(d, forms.f));
  s.g = through(q, forms.l) + through(d, forms.e);
  s.l = through(q, forms.g);
  s.m = (-2.0) * through(q, forms.f);
  s.n = through(q, forms.e);
  s.e.value += r.e - 0.5 * c;
  s.f.value += r.f;
  s.g.value += r.g - 0.5 * c;
  return s;
}

}  // namespace

Residuals MeanCurvatureGradient::residuals(const Jet& jet) const {
  const FundamentalForms forms = spline::fundamentalForms(jet);
  const auto r = values(forms, Terms<double>(forms));
  return Residuals(Eigen::Map<const Eigen::Vector2d>(r.data()));
}

ResidualsWithDerivatives MeanCurvatureGradient::linearised(const Jet& jet) const {
  const FundamentalForms forms = spline::fundamentalForms(jet);
  const Terms<double> t(forms);
  const auto r = values(forms, t);
  const double ca = t.c * t.a, cb = t.c * t.b, cf = t.c * forms.f.value;
  const Explicit explicitly[] = {
      {r[0], 0.0, -cb, ca, ca, t.c * (forms.g.value + t.w), -cf},
      {r[1], cb, -ca, 0.0, cb, -cf, t.c * (forms.e.value + t.w)},
  };
  ResidualsWithDerivatives result{Eigen::Map<const Eigen::Vector2d>(r.data()),
                                  ResidualDerivatives(2, 27)};
  for (int i = 0; i < 2; ++i)
    Eigen::Map<Jet>(result.derivatives.row(i).data()) =
        spline::pullBack(jet, slopesOf(forms, t, explicitly[i]));
  return result;
}

DensityExpansion MeanCurvatureGradient::expanded(const Jet& jet) const {
  using Number = SecondDual<kFormVariables>;
  const auto forms = formVariables<Number>(spline::fundamentalForms(jet));
  return squaredThroughForms(jet, values(forms, Terms<Number>(forms)));
}

}  // namespace fairing::shape_energy
