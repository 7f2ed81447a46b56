// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/spline/bspline_surface.h"

namespace fairing::spline {

struct SurfaceFoot {
  double u = 0.0, v = 0.0;
  double distance = 0.0;
  SurfaceJet jet;
};

/// The point of a patch nearest to `point`, from a close guess, by Newton's method kept inside the
/// patch's domain.
[[nodiscard]] SurfaceFoot closestPoint(const BsplineSurface& surface,
                                       const Eigen::Vector3d& point,
                                       double u,
                                       double v);

}  // namespace fairing::spline
