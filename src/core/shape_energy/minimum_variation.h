// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/shape_energy/shape_energy.h"

namespace fairing::shape_energy {

/// `umbilic` times the diagonal of a hole. What the fading at umbilics leaves of a cone's energy is
/// of its square.
inline constexpr double kUmbilicShare = 1e-4;

/// The integral of (dk1/de1)^2 + (dk2/de2)^2 over the surface: how fast each principal curvature
/// changes along its own line of curvature [MoretonSequin1992]. Zero for planes, spheres,
/// cylinders, cones, tori, and all cyclides. 1/mm^2.
///
/// At umbilics the principal directions e1, e2 are undefined. Where |k1 - k2| / 2 is not large
/// beside `umbilic`, the integrand fades into its mean over all directions, which needs none and is
/// zero for planes and spheres, too: it is smooth everywhere. Four residuals. Not finite where R_u
/// x R_v vanishes.
class MinimumVariation final : public ShapeEnergy {
 public:
  /// `umbilic` > 0, 1/mm: small beside the curvatures that matter.
  explicit MinimumVariation(double umbilic) : umbilic_(umbilic) {}

  [[nodiscard]] Residuals residuals(const Jet& jet) const override;
  [[nodiscard]] ResidualsWithDerivatives linearised(const Jet& jet) const override;
  [[nodiscard]] DensityExpansion expanded(const Jet& jet) const override;
  [[nodiscard]] int sizePower() const override { return -2; }

 private:
  double umbilic_;
};

}  // namespace fairing::shape_energy
