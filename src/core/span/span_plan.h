// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <functional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/span/fill_options.h"
#include "core/span/fill_result.h"
#include "core/span/span.h"
#include "core/span/span_hole.h"

namespace fairing {

/// The plan for a loop that patches are made for.
using PlanOf = std::function<Result<layout::LayoutPlan>(const boundary::BoundaryLoop& target)>;

/// A loop with all that spanPlan() needs: edges that lie off their faces are moved towards them as
/// far as the angles allowed ask (boundary/follow_support.h), and that is planned for. Fails as
/// `planOf` does.
[[nodiscard]] Result<Span> makeSpan(const boundary::BoundaryLoop& loop,
                                    const FillOptions& options,
                                    const PlanOf& planOf);

/// The patches of a plan, refined until they are within tolerance or the limits of the options are
/// reached. Fails with SystemSingular, NotFinite, SupportNormalSingular or Cancelled.
[[nodiscard]] Result<FillResult> spanPlan(const Span& span,
                                          const FillOptions& options,
                                          Progress* progress);

/// Patches of a plan again, on their knots, with some of their points held: the least bent
/// displacement (in the sense of the options' quadratic energy) that does so and meets all sides.
/// One solve, measured. Fails as spanPlan() does.
[[nodiscard]] Result<FillResult> spanAgain(const Span& span,
                                           const Patches& before,
                                           const HeldPoints& held,
                                           const FillOptions& options);

}  // namespace fairing
