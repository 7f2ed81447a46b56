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
/// steps; the others go to the minimum on these knots. Constraints hold exactly all along; a step
/// is taken only if the true energy falls. Where the thin plate has no normal somewhere, the shape
/// is the thin plate. Where the caller asks for the best so far (Progress::requestFinish), it is
/// what the steps have reached. docs/algorithms/shape_energies.md Fails with Cancelled and the
/// codes of makeProgram() and solve().
[[nodiscard]] Result<std::optional<FairShape>> fairShape(const layout::LayoutPlan& plan,
                                                         const layout::PatchLayout& layout,
                                                         const FillOptions& options,
                                                         double diagonal,
                                                         Progress* progress);

/// Goes on to the minimum on finer knots: those of the patches fitted to the shape, `fit` on
/// `fitted`, where these are few - a fit adds energy next to the sides, and these steps take it
/// away - else every span of the shape halved. False where no step was tried: that would be too
/// many, the energy takes a few steps only, it is undefined, or the best so far was asked for,
/// which the history then tells. Fails as fairShape() does.
[[nodiscard]] Result<bool> fairFurther(const layout::LayoutPlan& plan,
                                       const layout::PatchLayout& fitted,
                                       const Patches& fit,
                                       const FillOptions& options,
                                       double diagonal,
                                       Progress* progress,
                                       FairShape& shape);

}  // namespace fairing
