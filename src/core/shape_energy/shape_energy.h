// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>

#include "core/spline/fundamental_forms.h"

namespace fairing::shape_energy {

/// The partial derivatives of R that an energy of the shape depends on, one a column: R_u, R_v,
/// R_uu, R_uv, R_vv, R_uuu, R_uuv, R_uvv, R_vvv.
using Jet = spline::ThirdOrderJet;

inline constexpr int kMostResiduals = 4;
using Residuals = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostResiduals, 1>;
/// Row k: derivative of residual k with respect to the jet, column 3 * (jet column) + coordinate.
using ResidualDerivatives =
    Eigen::Matrix<double, Eigen::Dynamic, 27, Eigen::RowMajor, kMostResiduals, 27>;

struct ResidualsWithDerivatives {
  Residuals values;
  ResidualDerivatives derivatives;
};

/// Second derivatives with respect to the jet, rows and columns in its order.
using DensityHessian = Eigen::Matrix<double, 27, 27>;

/// The sum of squares of the residuals with its first and second derivatives.
struct DensityExpansion {
  double value = 0.0;
  Jet gradient;
  DensityHessian hessian;
};

/// An energy of the shape itself: the integral over the patch's parameters of the sum of squares of
/// a few residuals, which hold the square root of the area element. Independent of the
/// parametrisation. One file each; a new one needs nothing else.
class ShapeEnergy {
 public:
  virtual ~ShapeEnergy() = default;
  [[nodiscard]] virtual Residuals residuals(const Jet& jet) const = 0;
  [[nodiscard]] virtual ResidualsWithDerivatives linearised(const Jet& jet) const = 0;
  [[nodiscard]] virtual DensityExpansion expanded(const Jet& jet) const = 0;
  /// The energy of the surface scaled by s is s^sizePower() times its own.
  [[nodiscard]] virtual int sizePower() const = 0;
};

}  // namespace fairing::shape_energy
