// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/spline/bspline_surface.h"

namespace fairing::analysis {

/// Where a stretch of a side runs on a patch: the straight line from `start` to `end` in the
/// patch's parameters, affine in the side's parameter over [from, to]. Only a first guess of the
/// feet: the gap is measured to the surface.
struct SideTrace {
  int side = 0;
  int patch = 0;
  double from = 0.0, to = 1.0;
  Eigen::Vector2d start, end;
  /// The patch's parameters at a side parameter.
  [[nodiscard]] Eigen::Vector2d at(double t) const {
    return start + (end - start) * ((t - from) / (to - from));
  }
};

/// Measures patches against the loop they were made for, on points of its own (not the solver's).
[[nodiscard]] FillReport measureFill(const boundary::BoundaryLoop& loop,
                                     const LoopProbe& probe,
                                     const std::vector<spline::BsplineSurface>& patches,
                                     const std::vector<SideTrace>& traces,
                                     const Tolerance& tolerance);

}  // namespace fairing::analysis
