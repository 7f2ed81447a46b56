// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/shape_energy/minimum_variation.h"

#include <array>
#include <cmath>

#include "core/shape_energy/dual.h"
#include "core/shape_energy/form_variables.h"
#include "core/spline/fundamental_forms.h"

// C_ijk = h_ij;k, the covariant derivative of the second form, is symmetric in all three indices
// (Codazzi). In the orthonormal frame e1, e2 that is turned least against R_u, R_v the derivative
// of curvature along the direction cos t e1 + sin t e2, in itself, is
//   C(t) = Re(A e^-it + B e^-3it),   A = 3/4 (C111 + C122 + i (C112 + C222)) = 3/2 grad H,
//                                    B = 1/4 (C111 - 3 C122 + i (3 C112 - C222)).
// Along two orthogonal directions:  C(t)^2 + C(t + pi/2)^2 = |B + A* e^4it|^2. Its mean over t is
// |A|^2 + |B|^2. With the difference of curvatures q = (h11 - h22)/2 + i h12 the principal
// directions have e^4it = q^2 / |q|^2. So with p = q^2 / (|q|^2 + s^2), s = `umbilic`:
//   residuals  B + A* p  and  (1 - |p|^2)^1/2 A,  each times the root of the area element W;
//   the sum of squares is the wanted one for |q| >> s, and its mean for |q| << s.

namespace fairing::shape_energy {
namespace {

// The fundamental forms with scalars of type T.
template <class T>
using Field = spline::BasicFirstOrderJet<T>;
template <class T>
using Forms = spline::BasicFundamentalForms<T>;

template <class T>
struct Complex {
  T re, im;
};
template <class T>
Complex<T> operator*(const Complex<T>& a, const Complex<T>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

// Components of a symmetric tensor of order 3: those with 0, 1, 2 and 3 indices of the second kind.
template <class T>
using Cubic = std::array<T, 4>;

// D^(3/2) C_ijk in the parameters, D = W^2: second form times W against R_u x R_v, Christoffel
// symbols times D.
template <class T>
Cubic<T> derivativeOfSecondForm(const Forms<T>& x, const T& d) {
  const T &e = x.e.value, &f = x.f.value, &g = x.g.value;
  const T &l = x.l.value, &m = x.m.value, &n = x.n.value;
  const T du = x.e.u * g + e * x.g.u - 2.0 * (f * x.f.u);
  const T dv = x.e.v * g + e * x.g.v - 2.0 * (f * x.f.v);
  const T uuU = 0.5 * x.e.u, uuV = x.f.u - 0.5 * x.e.v;  // [uu, u] = R_uu . R_u, ...
  const T uvU = 0.5 * x.e.v, uvV = 0.5 * x.g.u;
  const T vvU = x.f.v - 0.5 * x.g.u, vvV = 0.5 * x.g.v;
  const auto component = [&](const Field<T>& h, bool alongU, const T& first, const T& second) {
    return d * (alongU ? h.u : h.v) - 0.5 * (h.value * (alongU ? du : dv)) - 2.0 * (first + second);
  };
  const auto raisedU = [&](const T& a, const T& b) { return g * a - f * b; };
  const auto raisedV = [&](const T& a, const T& b) { return e * b - f * a; };
  return {component(x.l, true, raisedU(uuU, uuV) * l, raisedV(uuU, uuV) * m),
          component(x.l, false, raisedU(uvU, uvV) * l, raisedV(uvU, uvV) * m),
          component(x.n, true, raisedU(uvU, uvV) * m, raisedV(uvU, uvV) * n),
          component(x.n, false, raisedU(vvU, vvV) * m, raisedV(vvU, vvV) * n)};
}

// One index contracted with (a, b) after the other: the tensor of order k + 1 in k + 2 components
// becomes one of order k.
template <class T>
std::array<T, 3> contracted(const Cubic<T>& c, const T& a, const T& b) {
  return {a * c[0] + b * c[1], a * c[1] + b * c[2], a * c[2] + b * c[3]};
}
template <class T>
std::array<T, 2> contracted(const std::array<T, 3>& c, const T& a, const T& b) {
  return {a * c[0] + b * c[1], a * c[1] + b * c[2]};
}
template <class T>
T contracted(const std::array<T, 2>& c, const T& a, const T& b) {
  return a * c[0] + b * c[1];
}

template <class T>
std::array<T, 4> residualsOf(const Forms<T>& forms, double umbilic) {
  using std::sqrt;
  const T &e = forms.e.value, &f = forms.f.value, &g = forms.g.value;
  const T d = e * g - f * f, w = sqrt(d), root = sqrt(w), minusF = -1.0 * f;
  // The frame: e1 = (x R_u - F R_v) / (s W), e2 = (y R_v - F R_u) / (s W).
  const T x = g + w, y = e + w, s2 = x + y, s = sqrt(s2);

  const std::array<T, 3> h{forms.l.value, forms.m.value, forms.n.value};
  const auto h1 = contracted(h, x, minusF), h2 = contracted(h, minusF, y);
  const T toFrame2 = 1.0 / (s2 * d * w);
  const Complex<T> q{0.5 * ((contracted(h1, x, minusF) - contracted(h2, minusF, y)) * toFrame2),
                     contracted(h1, minusF, y) * toFrame2};

  const Cubic<T> c = derivativeOfSecondForm(forms, d);
  const auto c1 = contracted(c, x, minusF), c2 = contracted(c, minusF, y);
  const auto c11 = contracted(c1, x, minusF), c22 = contracted(c2, minusF, y);
  const T toFrame3 = root / (s2 * s * d * d * d);  // times the root of the area element
  const T c111 = contracted(c11, x, minusF) * toFrame3;
  const T c112 = contracted(c11, minusF, y) * toFrame3;
  const T c122 = contracted(c22, x, minusF) * toFrame3;
  const T c222 = contracted(c22, minusF, y) * toFrame3;

  const Complex<T> a{0.75 * (c111 + c122), 0.75 * (c112 + c222)};
  const Complex<T> b{0.25 * (c111 - 3.0 * c122), 0.25 * (3.0 * c112 - c222)};
  const T size2 = q.re * q.re + q.im * q.im, soft = 1.0 / (size2 + T(umbilic * umbilic));
  const Complex<T> conjugate{a.re, -1.0 * a.im}, square = q * q;
  const Complex<T> turned = conjugate * square;
  const T mean = umbilic * (soft * sqrt(2.0 * size2 + T(umbilic * umbilic)));
  return {b.re + soft * turned.re, b.im + soft * turned.im, mean * a.re, mean * a.im};
}

}  // namespace

Residuals MinimumVariation::residuals(const Jet& jet) const {
  const auto r = residualsOf(spline::fundamentalForms(jet), umbilic_);
  return Residuals(Eigen::Map<const Eigen::Vector4d>(r.data()));
}

ResidualsWithDerivatives MinimumVariation::linearised(const Jet& jet) const {
  const auto r =
      residualsOf(formVariables<Dual<kFormVariables>>(spline::fundamentalForms(jet)), umbilic_);
  ResidualsWithDerivatives result{Residuals(4), ResidualDerivatives(4, 27)};
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    result.values[i] = r[k].value;
    Eigen::Map<Jet>(result.derivatives.row(i).data()) = spline::pullBack(jet, slopesOf(r[k].slope));
  }
  return result;
}

DensityExpansion MinimumVariation::expanded(const Jet& jet) const {
  const auto forms = formVariables<SecondDual<kFormVariables>>(spline::fundamentalForms(jet));
  return squaredThroughForms(jet, residualsOf(forms, umbilic_));
}

}  // namespace fairing::shape_energy
