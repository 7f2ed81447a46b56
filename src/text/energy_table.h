// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/energy/energy_kind.h"
#include "core/span/fill_result.h"

namespace fairing::text {

/// What became of one fill with one of the energies.
struct EnergyLine {
  EnergyKind energy = EnergyKind::ThinPlate;
  const FillResult* fill = nullptr;
  const Error* error = nullptr;  ///< read where `fill` is null
};

/// One line an energy under a head line: gap, angle, curvature (where any side asks for G2), the
/// values of the energies, seconds. Ends with a line break.
[[nodiscard]] std::string table(const std::vector<EnergyLine>& energies);

}  // namespace fairing::text
