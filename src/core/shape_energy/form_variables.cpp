// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/shape_energy/form_variables.h"

// With the forms phi(J) and a density f(phi):
//   d2f/dJ2 = (dphi/dJ)' f'' dphi/dJ + sum_k f'_k d2phi_k/dJ2.

namespace fairing::shape_energy {

using Slopes = Eigen::Array<double, kFormVariables, 1>;

spline::FundamentalForms slopesOf(const Slopes& s) {
  const auto jet = [&](int k) { return spline::FirstOrderJet{s[k], s[k + 1], s[k + 2]}; };
  return {jet(0), jet(3), jet(6), jet(9), jet(12), jet(15)};
}

DensityExpansion throughForms(const Jet& jet, const SecondDual<kFormVariables>& density) {
  using Flat = Eigen::Map<const Eigen::Matrix<double, 27, 1>>;
  const spline::FundamentalForms slopes = slopesOf(density.slope);
  Eigen::Matrix<double, 27, kFormVariables> forms;  // d phi / dJ, a column each
  for (int k = 0; k < kFormVariables; ++k) {
    Slopes unit = Slopes::Zero();
    unit[k] = 1.0;
    forms.col(k) = Flat(spline::pullBack(jet, slopesOf(unit)).eval().data());
  }
  DensityExpansion made;
  made.value = density.value;
  made.gradient = spline::pullBack(jet, slopes);
  made.hessian = forms * density.curveMatrix() * forms.transpose();
  for (int k = 0; k < 27; ++k) {
    Jet along = Jet::Zero();
    along.data()[k] = 1.0;
    made.hessian.col(k) += Flat(spline::pullBackChange(jet, along, slopes).eval().data());
  }
  return made;
}

}  // namespace fairing::shape_energy
