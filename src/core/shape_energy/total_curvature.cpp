// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/shape_energy/total_curvature.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/shape_energy/form_variables.h"
#include "core/spline/fundamental_forms.h"

// With W^2 = D = E G - F^2 the inverse square root of the first form is
//   [x, -F; -F, y] / (s W),   x = G + W,   y = E + W,   s^2 = E + G + 2 W.
// On both sides of the second form [L, M; M, N] / W (against R_u x R_v) it gives the shape operator
// in an orthonormal frame, and times the root of the area element the residuals
//   [r1, r2/sqrt 2; r2/sqrt 2, r3] = c [x, -F; -F, y] [L, M; M, N] [x, -F; -F, y],
//   c = 1 / (s^2 W^(5/2)).

namespace fairing::shape_energy {
namespace {

using spline::FundamentalForms;
using std::sqrt;

constexpr double kRoot2 = std::numbers::sqrt2;

template <class T>
struct Terms {
  explicit Terms(const spline::BasicFundamentalForms<T>& forms)
      : e(forms.e.value),
        f(forms.f.value),
        g(forms.g.value),
        l(forms.l.value),
        m(forms.m.value),
        n(forms.n.value),
        d(e * g - f * f),
        w(sqrt(d)),
        x(g + w),
        y(e + w),
        s2(x + y),
        c(1.0 / (s2 * d * sqrt(w))) {}

  T e, f, g, l, m, n, d, w, x, y, s2, c;
};

template <class T>
std::array<T, 3> values(const Terms<T>& t) {
  return {t.c * (t.x * (t.x * t.l - 2.0 * t.f * t.m) + t.f * t.f * t.n),
          kRoot2 * t.c * ((t.f * t.f + t.x * t.y) * t.m - t.f * (t.x * t.l + t.y * t.n)),
          t.c * (t.y * (t.y * t.n - 2.0 * t.f * t.m) + t.f * t.f * t.l)};
}

// A residual and its derivatives where x, y, F, L, M, N stand by themselves in the product.
struct Explicit {
  double value;
  double x, y, f, l, m, n;
};

FundamentalForms slopesOf(const Terms<double>& t, const Explicit& r) {
  const double c = r.value / t.s2;  // -dr/ds^2
  const double w = r.x + r.y - 2.0 * c;
  const double d = 0.5 * w / t.w - 1.25 * r.value / t.d;
  FundamentalForms s;
  s.e.value = r.y - c + d * t.g;
  s.f.value = r.f - 2.0 * d * t.f;
  s.g.value = r.x - c + d * t.e;
  s.l.value = r.l;
  s.m.value = r.m;
  s.n.value = r.n;
  return s;
}

}  // namespace

Residuals TotalCurvature::residuals(const Jet& jet) const {
  const auto r = values(Terms<double>(spline::fundamentalForms(jet)));
  return Residuals(Eigen::Map<const Eigen::Vector3d>(r.data()));
}

ResidualsWithDerivatives TotalCurvature::linearised(const Jet& jet) const {
  const Terms<double> t(spline::fundamentalForms(jet));
  const auto r = values(t);
  const double xf = t.x * t.f, yf = t.y * t.f, ff = t.f * t.f, c = t.c, c2 = kRoot2 * t.c;
  const Explicit explicitly[] = {
      {r[0],
       2.0 * c * (t.x * t.l - t.f * t.m),
       0.0,
       2.0 * c * (t.f * t.n - t.x * t.m),
       c * t.x * t.x,
       -2.0 * c * xf,
       c * ff},
      {r[1],
       c2 * (t.y * t.m - t.f * t.l),
       c2 * (t.x * t.m - t.f * t.n),
       c2 * (2.0 * t.f * t.m - t.x * t.l - t.y * t.n),
       -c2 * xf,
       c2 * (ff + t.x * t.y),
       -c2 * yf},
      {r[2],
       0.0,
       2.0 * c * (t.y * t.n - t.f * t.m),
       2.0 * c * (t.f * t.l - t.y * t.m),
       c * ff,
       -2.0 * c * yf,
       c * t.y * t.y},
  };
  ResidualsWithDerivatives result{Eigen::Map<const Eigen::Vector3d>(r.data()),
                                  ResidualDerivatives(3, 27)};
  for (int i = 0; i < 3; ++i)
    Eigen::Map<Jet>(result.derivatives.row(i).data()) =
        spline::pullBack(jet, slopesOf(t, explicitly[i]));
  return result;
}

DensityExpansion TotalCurvature::expanded(const Jet& jet) const {
  using Number = SecondDual<kFormVariables>;
  const auto forms = formVariables<Number>(spline::fundamentalForms(jet));
  return squaredThroughForms(jet, values(Terms<Number>(forms)));
}

}  // namespace fairing::shape_energy
