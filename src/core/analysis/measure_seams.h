// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/spline/bspline_surface.h"

namespace fairing::analysis {

/// A straight line on a patch's parameters.
struct SeamTrace {
  int patch = 0;
  Eigen::Vector2d start, end;
};

/// A seam, run through in the same direction on both patches.
struct SeamTraces {
  SeamTrace first, second;
  bool crease = false;                ///< to be met in position only
  Continuity asked = Continuity::G1;  ///< what is asked where it is no crease: G1 or G2
};

/// Gap, angle between the normals, curvature mismatch and jump of every seam, at equal shares of
/// both traces. `diagonal` of the loop, mm: curvatures below 1 % of its reciprocal count as flat.
[[nodiscard]] std::vector<SeamReport> measureSeams(
    const std::vector<spline::BsplineSurface>& patches,
    const std::vector<SeamTraces>& seams,
    double diagonal);

/// Adds the seams to a report, and what they mean to its verdict: gaps, angles and, where G2 is
/// asked, jumps of curvature count as the sides' do.
void addSeams(FillReport& report,
              const std::vector<spline::BsplineSurface>& patches,
              const std::vector<SeamTraces>& seams);

}  // namespace fairing::analysis
