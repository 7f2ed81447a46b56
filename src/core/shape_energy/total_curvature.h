// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/shape_energy/shape_energy.h"

namespace fairing::shape_energy {

/// The integral of k1^2 + k2^2 over the surface: how much it bends, the thin plate's energy freed
/// of the parameters [MoretonSequin1992]. Zero for planes alone, the same at every size.
///
/// Three residuals, the entries of the shape operator against the orthonormal frame that is turned
/// least against R_u, R_v: no principal directions, so umbilics are points like others. Not finite
/// where R_u x R_v vanishes.
class TotalCurvature final : public ShapeEnergy {
 public:
  [[nodiscard]] Residuals residuals(const Jet& jet) const override;
  [[nodiscard]] ResidualsWithDerivatives linearised(const Jet& jet) const override;
  [[nodiscard]] DensityExpansion expanded(const Jet& jet) const override;
  [[nodiscard]] int sizePower() const override { return 0; }
};

}  // namespace fairing::shape_energy
