// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/shape_energy/shape_energy.h"

namespace fairing::shape_energy {

/// The integral of |grad H|^2 over the surface, grad the gradient on the surface itself: how fast
/// the mean curvature changes [Kiciak2011]. Zero for planes, spheres and cylinders, and any other
/// surface of constant mean curvature. 1/mm^2.
///
/// Two residuals, grad H against the orthonormal frame that is turned least against R_u, R_v, so
/// that neither direction is preferred. Not finite where R_u x R_v vanishes.
class MeanCurvatureGradient final : public ShapeEnergy {
 public:
  [[nodiscard]] Residuals residuals(const Jet& jet) const override;
  [[nodiscard]] ResidualsWithDerivatives linearised(const Jet& jet) const override;
  [[nodiscard]] DensityExpansion expanded(const Jet& jet) const override;
  [[nodiscard]] int sizePower() const override { return -2; }
};

}  // namespace fairing::shape_energy
