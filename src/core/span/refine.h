// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <set>
#include <vector>

#include "core/analysis/measure_fill.h"
#include "core/analysis/measure_seams.h"
#include "core/layout/layouts.h"
#include "core/span/fill_result.h"

namespace fairing {

/// Where the sides of the loop that was cut run on the patches of a layout.
[[nodiscard]] std::vector<analysis::SideTrace> sideTraces(const layout::LayoutPlan& plan,
                                                          const layout::PatchLayout& layout);

/// Where the seams run.
[[nodiscard]] std::vector<analysis::SeamTraces> seamTraces(const layout::PatchLayout& layout);

/// The middle of the span that holds t, unless the span is as short as it may be. A place on a
/// break belongs to both spans: rounding must not choose between them.
[[nodiscard]] std::set<double> middlesAt(const spline::KnotVector& knots, double t);

/// Refinement goes on until the deviations are below this share of the limits: they are sampled,
/// the peaks lie between.
inline constexpr double kRefineAim = 0.6;

/// The knots that would help most: the middle of every span next to which a side is over `aim`
/// times a limit of the report, but for what is the edge's own fault. Spans at corners whose twists
/// disagree are halved again and again, which grades the knots towards them with ratio 1/2.
[[nodiscard]] std::vector<layout::KnotWish> wishedKnots(const layout::LayoutPlan& plan,
                                                        const layout::PatchLayout& layout,
                                                        const analysis::FillReport& report,
                                                        double aim);
[[nodiscard]] bool nothingWished(const std::vector<layout::KnotWish>& wishes);

/// How far over its limits a report is; 1 = just within. The sum over the sides tells reports apart
/// whose worst place is the same. A patch that leaves a side backwards is worse than any.
[[nodiscard]] double excess(const analysis::FillReport& report);

/// The one of two results that is less over its limits; it keeps the count of solves of the later
/// one.
[[nodiscard]] FillResult better(FillResult before, FillResult after);

}  // namespace fairing
