// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/analysis/loop_probe.h"
#include "core/boundary/boundary_loop.h"
#include "core/layout/layout_plan.h"

namespace fairing {

/// What is to be spanned: the sides as they are, which the result is measured against, and the way
/// they are to be spanned.
struct Span {
  boundary::BoundaryLoop loop;
  boundary::BoundaryLoop target;  ///< it, its edges moved towards their faces
  analysis::LoopProbe probe;      ///< of loop and target
  layout::LayoutPlan plan;        ///< made for target
};

}  // namespace fairing
