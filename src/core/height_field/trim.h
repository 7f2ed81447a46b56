// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/height_field/plane_frame.h"
#include "core/spline/bspline_curve.h"

namespace fairing {

/// A border curve of a trimmed patch: in space and in the patch's parameters, on the same knots,
/// and of the same point at the same parameter.
struct TrimCurve {
  int edge = 0;  ///< of the loop, FreeCAD's number
  spline::BsplineCurve inSpace;
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> parameters;  ///< poles: (u, v)
};

/// The border of a trimmed patch, closed, head to tail, the patch to its left in its parameters.
/// Empty where the patch is not trimmed.
struct Trim {
  std::vector<TrimCurve> curves;
};

namespace height_field {

/// The trim of a height field by a loop: its sides, seen in the plane. Polynomial sides are taken
/// over, others are fitted to `fitTolerance` (mm).
[[nodiscard]] Trim trimBy(const boundary::BoundaryLoop& loop,
                          const PlaneFrame& frame,
                          double fitTolerance);

}  // namespace height_field
}  // namespace fairing
