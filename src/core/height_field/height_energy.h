// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/energy/energy_kind.h"
#include "core/height_field/domain_grid.h"
#include "core/height_field/height_system.h"

namespace fairing::height_field {

/// The integrand of an energy of the height at a place, as squares of linear forms on the jet:
///   membrane                 h_u^2 + h_v^2
///   thin plate               h_uu^2 + 2 h_uv^2 + h_vv^2
///   mean curvature gradient  |grad laplace h|^2, what |grad H|^2 is to first order where the
///                            surface is level, and a little of all third derivatives
///   minimum variation        the mean of h_ddd^2 + h_eee^2 over all orthogonal directions d, e:
///                            what it is where the surface is level
///   total curvature          the thin plate, for the same reason
[[nodiscard]] std::vector<EnergySquare> quadraticSquares(EnergyKind kind);

/// Whether an energy is also that of the surface itself, by Gauss-Newton steps: mean curvature
/// gradient.
[[nodiscard]] bool isLinearised(EnergyKind kind);

/// |grad H|^2 dA of the surface itself, linearised about a height: its squares are those of the
/// Gauss-Newton method. [Kiciak2011]
[[nodiscard]] std::vector<EnergySquare> meanCurvatureGradientSquares(const Jet& jet);

/// Adds the energy of a height: of what lies inside the loop, and a small share of the same outside
/// of it, which settles the poles there. With `about`, an energy that isLinearised() is that of the
/// surface itself, linearised there.
void addEnergy(HeightSystem& system,
               const DomainGrid& grid,
               EnergyKind kind,
               const Heights* about = nullptr);

/// Integral of |grad 2H|^2 over the surface inside the loop, in the frame's units.
[[nodiscard]] double shapeEnergy(const DomainGrid& grid, const Heights& heights);

}  // namespace fairing::height_field
