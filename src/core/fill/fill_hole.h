// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/boundary/boundary_loop.h"
#include "core/span/fill_options.h"
#include "core/span/fill_result.h"

namespace fairing {

/// Spans a loop with patches that meet its sides as each side asks and minimise the chosen energy.
/// Refines until the tolerance is met or the limits of the options are reached; then the best
/// result found is returned and its report says that it is out of tolerance. Fails with the codes
/// of validate(), WrongSideCount, SystemSingular, NotFinite or Cancelled; never returns unmeasured
/// patches. [WuYang2015], see docs/algorithms/quad_fill.md.
[[nodiscard]] Result<FillResult> fillHole(const boundary::BoundaryLoop& loop,
                                          const FillOptions& options,
                                          Progress* progress = nullptr);

}  // namespace fairing
