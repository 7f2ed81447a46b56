// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/solver/band_matrix.h"
#include "core/uniform_patch/free_points.h"

namespace fairing::uniform_patch {

/// T = integral of |grad lap p|^2 over the parameters, [Kiciak2011] section 3: a quadratic form in
/// the control points, exact.
[[nodiscard]] double triharmonicEnergy(const ControlNet& net);

/// The second derivative of T / 2 with respect to one coordinate of the free points.
[[nodiscard]] solver::BandMatrix triharmonicStiffness(const ControlNet& net,
                                                      const FreePoints& free);

/// The net that minimises T over the free points: lap^3 p = 0 in the weak sense. One banded
/// factorisation for x, y and z. Fails with SystemSingular.
[[nodiscard]] Result<ControlNet> triharmonicNet(const ConstrainedNet& given);

}  // namespace fairing::uniform_patch
