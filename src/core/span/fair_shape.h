// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/base/progress.h"
#include "core/span/span_hole.h"

namespace fairing {

/// The shape a hole is to have, on few knots: it meets the sides only as well as these allow.
struct FairShape {
  layout::PatchLayout layout;
  Patches patches;
  double energyBefore = 0.0;  ///< of the quadratic start, 1/mm^2
  double energy = 0.0;        ///< reached, 1/mm^2
  int steps = 0;              ///< Gauss-Newton steps accepted
};

/// Minimises the energy of the shape that the options ask for by Gauss-Newton steps from the
/// minimiser of the thin plate; nothing where the energy is quadratic. Constraints hold exactly all
/// along; a step is taken only if the true energy falls. docs/algorithms/shape_energies.md
/// Fails with Cancelled and the codes of makeProgram() and solve().
[[nodiscard]] Result<std::optional<FairShape>> fairShape(const layout::LayoutPlan& plan,
                                                         const layout::PatchLayout& layout,
                                                         const FillOptions& options,
                                                         double diagonal,
                                                         Progress* progress);

}  // namespace fairing
