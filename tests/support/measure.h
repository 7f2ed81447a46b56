// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/boundary/boundary_loop.h"
#include "core/spline/bspline_surface.h"

namespace fairing::testing {

/// Deviations of one quad patch from its loop by means of our own: foot by search over the patch's
/// border line, on places that neither solver nor report use.
struct QuadDeviation {
  double gap = 0.0;          ///< mm
  double angle = 0.0;        ///< degrees, within 2 % to 98 % of the side's parameter
  double cornerAngle = 0.0;  ///< degrees, outside of it
};

/// Of side `side` (0 South, 1 East, 2 North, 3 West), over the stretch [from, to] of its parameter.
[[nodiscard]] QuadDeviation deviationOf(const boundary::BoundaryLoop& loop,
                                        const spline::BsplineSurface& patch,
                                        std::size_t side,
                                        double from = 0.0,
                                        double to = 1.0);
/// The worst over the four sides.
[[nodiscard]] QuadDeviation deviationOf(const boundary::BoundaryLoop& loop,
                                        const spline::BsplineSurface& patch);

/// The largest distance of a patch's points from a plane through `point`.
[[nodiscard]] double distanceFromPlane(const spline::BsplineSurface& patch,
                                       const Eigen::Vector3d& point,
                                       const Eigen::Vector3d& normal);

}  // namespace fairing::testing
