// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/base/progress.h"
#include "core/solver/solve_summary.h"
#include "core/span/span_hole.h"

namespace fairing {

/// The shape a hole is to have, on few knots: it meets the sides only as well as these allow.
struct FairShape {
  layout::PatchLayout layout;
  Patches patches;
  double energy = 0.0;  ///< reached, in its own unit
  solver::ShapeHistory history;
};

/// Lowers the energy of the shape that the options ask for by Gauss-Newton steps from the minimiser
/// of the thin plate; nothing where the energy is quadratic. MeanCurvatureGradient takes a few
/// steps; the others go to the minimum, on these knots and then on twice as many. Constraints hold
/// exactly all along; a step is taken only if the true energy falls. Where the thin plate has no
/// normal somewhere, the shape is the thin plate. Where the caller asks for the best so far
/// (Progress::requestFinish), it is what the steps have reached. docs/algorithms/shape_energies.md
/// Fails with Cancelled and the codes of makeProgram() and solve().
[[nodiscard]] Result<std::optional<FairShape>> fairShape(const layout::LayoutPlan& plan,
                                                         const layout::PatchLayout& layout,
                                                         const FillOptions& options,
                                                         double diagonal,
                                                         Progress* progress);

}  // namespace fairing
