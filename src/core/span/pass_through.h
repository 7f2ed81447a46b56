// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/constraint/inner_constraint.h"
#include "core/layout/layouts.h"
#include "core/span/span_hole.h"

namespace fairing {

/// Patches pass through given points: R(u, v) = P at the feet of the points on `about`, as ties of
/// the control points near them. A curve is taken at as many places as the patches have freedoms
/// along it. Points flagged as `taken` belong to the sides and are left to them.
/// Repeated about its own solution, the feet and the points become one.
[[nodiscard]] std::vector<solver::TieBlock> passThrough(
    const layout::PatchLayout& layout,
    const Patches& about,
    const std::vector<InnerConstraint>& constraints,
    const std::vector<char>& taken);

/// Adds to a report how far the patches miss the constraints: they count as gaps do.
void addInner(analysis::FillReport& report,
              const Patches& patches,
              const std::vector<InnerConstraint>& constraints);

/// Adds the middles of all spans in which a constraint is missed by more than `limit` mm.
void wishForInner(const layout::PatchLayout& layout,
                  const Patches& patches,
                  const std::vector<InnerConstraint>& constraints,
                  double limit,
                  std::vector<layout::KnotWish>& wishes);

}  // namespace fairing
