// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/energy/energy_kind.h"

namespace fairing::energy {

/// Orders of a partial derivative: d^(u+v) R / du^u dv^v.
struct PartialDerivative {
  int u = 0, v = 0;
};

/// weight times the integral of  dR/d(a) . dR/d(b)  over the patch's parameters.
struct EnergyTerm {
  double weight = 1.0;
  PartialDerivative a, b;
};

/// A quadratic energy 1/2 sum of its terms. Symmetric: a term with a != b stands for both orders,
/// half each.
using EnergyTerms = std::vector<EnergyTerm>;

/// [WuYang2015] eq. 1 with lambda = gamma = 0: |R_u|^2 + |R_v|^2.
[[nodiscard]] EnergyTerms membrane();
/// [WuYang2015] eq. 2 with lambda = gamma = 0: |R_uu|^2 + 2 |R_uv|^2 + |R_vv|^2.
[[nodiscard]] EnergyTerms thinPlate();

/// T of [Kiciak2011] section 3, doubled: |grad laplace R|^2, of third order. Nought for every R
/// whose laplacian is constant: the sides have to say where the surface leaves them.
[[nodiscard]] EnergyTerms triharmonic();

/// The one list of the choices.
[[nodiscard]] EnergyTerms energyTerms(EnergyKind kind);

}  // namespace fairing::energy
