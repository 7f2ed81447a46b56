// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/layout/patch_layout.h"

namespace fairing::layout {

/// Knots on [0, 1] of a four-sided patch, u along sides 0 and 2, v along sides 1 and 3.
struct QuadKnots {
  spline::KnotVector u, v;
};

/// The coarsest knots on which the four sides can be written (chooseKnots in side_curves.h).
[[nodiscard]] QuadKnots chooseQuadKnots(const boundary::BoundaryLoop& loop,
                                        int degree,
                                        double fitTolerance,
                                        int maxPoles);

/// One patch between four sides: side 0 South, 1 East, 2 North, 3 West. Fails with WrongSideCount.
[[nodiscard]] Result<PatchLayout> quadLayout(const boundary::BoundaryLoop& loop,
                                             const QuadKnots& knots);

}  // namespace fairing::layout
