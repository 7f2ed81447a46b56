// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/energy.h"

namespace fairing::energy {
namespace {

// Of the plate, beside |grad lap R|^2, which quadratic polynomials cost nothing: v (1 - v) times
// the direction in which a strip leaves both its sides, or what G0 sides leave open.
constexpr double kDetermining = 1e-3;

EnergyTerms determined(EnergyTerms terms) {
  for (EnergyTerm term : thinPlate()) {
    term.weight *= kDetermining;
    terms.push_back(term);
  }
  return terms;
}

}  // namespace

EnergyTerms energyTerms(EnergyKind kind) {
  switch (kind) {
    case EnergyKind::Membrane:
      return membrane();
    case EnergyKind::Triharmonic:
      return determined(triharmonic());
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
