// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/boundary/boundary_loop.h"
#include "core/fill/fill_options.h"
#include "core/height_field/trim.h"
#include "core/solver/solve_summary.h"
#include "core/spline/bspline_surface.h"

namespace fairing {

/// A filled hole: patches, what was measured on them, and how they came about.
struct FillResult {
  std::vector<spline::BsplineSurface> patches;
  std::vector<bool> reversed;  ///< patch i's normal u x v points against the support normals
  std::vector<Trim> trims;     ///< the border of patch i; empty: no patch is trimmed
  LayoutKind layout = LayoutKind::Quad;
  analysis::FillReport report;
  solver::SolveSummary summary;
};

/// Spans a loop with patches that meet its sides as each side asks and minimise the chosen energy.
/// Refines until the tolerance is met or the limits of the options are reached; then the best
/// result found is returned and its report says that it is out of tolerance. Fails with the codes
/// of validate(), WrongSideCount, SystemSingular, NotFinite or Cancelled; never returns unmeasured
/// patches. [WuYang2015], see docs/algorithms/quad_fill.md.
[[nodiscard]] Result<FillResult> fillHole(const boundary::BoundaryLoop& loop,
                                          const FillOptions& options,
                                          Progress* progress = nullptr);

}  // namespace fairing
