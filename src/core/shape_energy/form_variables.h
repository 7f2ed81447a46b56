// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/shape_energy/second_dual.h"
#include "core/shape_energy/shape_energy.h"
#include "core/spline/fundamental_forms.h"

namespace fairing::shape_energy {

/// The numbers in spline::FundamentalForms: value, u and v of E, F, G, L, M, N in turn.
inline constexpr int kFormVariables = 18;

/// The fundamental forms with every number a variable of its own. Scalar: Dual or SecondDual.
template <class Scalar>
spline::BasicFundamentalForms<Scalar> formVariables(const spline::FundamentalForms& forms) {
  int k = 0;
  const auto jet = [&](const spline::FirstOrderJet& of) {
    spline::BasicFirstOrderJet<Scalar> made{Scalar::variable(of.value, k),
                                            Scalar::variable(of.u, k + 1),
                                            Scalar::variable(of.v, k + 2)};
    k += 3;
    return made;
  };
  // Braces keep the order.
  return {jet(forms.e), jet(forms.f), jet(forms.g), jet(forms.l), jet(forms.m), jet(forms.n)};
}

/// Derivatives with respect to the variables, put back in their places.
[[nodiscard]] spline::FundamentalForms slopesOf(const Eigen::Array<double, kFormVariables, 1>& s);

/// A density in the fundamental forms as one of the jet: the chain rule of second order.
[[nodiscard]] DensityExpansion throughForms(const Jet& jet,
                                            const SecondDual<kFormVariables>& density);

/// The same, of the sum of squares of residuals.
template <class Residuals>
DensityExpansion squaredThroughForms(const Jet& jet, const Residuals& residuals) {
  SecondDual<kFormVariables> sum(0.0);
  for (const SecondDual<kFormVariables>& r : residuals) sum = sum + r * r;
  return throughForms(jet, sum);
}

}  // namespace fairing::shape_energy
