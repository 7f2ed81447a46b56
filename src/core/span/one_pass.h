// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/solver/solve.h"
#include "core/span/fill_options.h"
#include "core/span/fill_result.h"
#include "core/span/span.h"
#include "core/span/span_hole.h"

namespace fairing {

/// The patches of a span on given knots, measured: without guidance, then under it where it acts.
/// Fails with FieldManyPatches, SupportNormalSingular, the codes of solver::solve() and Cancelled.
[[nodiscard]] Result<FillResult> fillOn(const Span& span,
                                        const layout::PatchLayout& layout,
                                        Aim aim,
                                        const FillOptions& options,
                                        Progress* progress = nullptr);

/// A solution's patches with what is measured on them: border, seams, inner constraints.
[[nodiscard]] FillResult measureSpan(const Span& span,
                                     const layout::PatchLayout& layout,
                                     const solver::Solution& solution,
                                     const FillOptions& options);

}  // namespace fairing
