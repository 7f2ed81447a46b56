// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/boundary/boundary_loop.h"
#include "core/layout/patch_layout.h"
#include "core/spline/bspline_surface.h"
#include "support/known_loops.h"

namespace fairing::testing {

/// Straight sides in a surface's parameters round a regular polygon, `turned` by an angle.
[[nodiscard]] Sides polygonOn(const KnownSurface& surface,
                              int corners,
                              double radius = 1.0,
                              double turned = 0.0);
/// One closed side: the circle in a surface's parameters, from the angle `from` on.
[[nodiscard]] Sides circleOn(const KnownSurface& surface, double radius, double from = 0.0);
/// Two sides round the same circle, neither at constant speed.
[[nodiscard]] Sides halfCirclesOn(const KnownSurface& surface, double radius);
/// The octant x, y, z > 0 of a sphere, three sides.
[[nodiscard]] Sides sphereOctant(double radius);
/// The same sides, each with this continuity.
[[nodiscard]] Sides asking(Sides sides, Continuity continuity);

/// The parameters of a patch at a share t of one of its edges, in the border's direction.
[[nodiscard]] Eigen::Vector2d onEdge(const spline::BsplineSurface& patch,
                                     layout::PatchEdge edge,
                                     double t);

}  // namespace fairing::testing
