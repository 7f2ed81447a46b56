// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/shape_energy/shape_energy.h"

namespace fairing::testing {

/// What every energy of the shape obeys; each reports its failures on random jets.
/// First and second derivatives are those of differences, and all entries give the same values.
void expectExactDerivatives(const shape_energy::ShapeEnergy& energy, Eigen::Index residuals);
/// The same on one jet: where a formula might break down.
void expectExactDerivativesAt(const shape_energy::ShapeEnergy& energy,
                              const shape_energy::Jet& jet);
/// Turning the surface in space changes no residual.
void expectRigidInvariance(const shape_energy::ShapeEnergy& energy);
/// The energy of the surface scaled by s is s^sizePower() times its own.
void expectScaling(const shape_energy::ShapeEnergy& energy);
/// Any linear change of the parameters multiplies the density by that of the area.
void expectParameterInvariance(const shape_energy::ShapeEnergy& energy);

}  // namespace fairing::testing
