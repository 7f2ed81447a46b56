// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/energy.h"

namespace fairing::energy {

EnergyTerms energyTerms(EnergyKind kind) {
  switch (kind) {
    case EnergyKind::Membrane:
      return membrane();
    case EnergyKind::Triharmonic:
      return triharmonic();
    case EnergyKind::ThinPlate:
    case EnergyKind::MeanCurvatureGradient:  // energies of the shape start from the plate
    case EnergyKind::MeanCurvatureGradientMinimum:
    case EnergyKind::MinimumVariation:
    case EnergyKind::TotalCurvature:
      break;
  }
  return thinPlate();
}

}  // namespace fairing::energy
