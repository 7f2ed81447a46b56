// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/height_surface.h"

namespace fairing::height_field {

// A B-spline whose poles are the Greville abscissae is its own parameter.
spline::BsplineSurface surfaceOf(const Heights& heights, const PlaneFrame& frame) {
  spline::BsplineSurface surface{heights.u, heights.v, {}};
  surface.poles.resize(heights.poles.size(), 3);
  for (int i = 0; i < heights.u.poleCount(); ++i)
    for (int j = 0; j < heights.v.poleCount(); ++j) {
      const int k = surface.index(i, j);
      const Eigen::Vector3d at(heights.u.greville(i), heights.v.greville(j), heights.poles[k]);
      surface.poles.row(k) = frame.point(at).transpose();
    }
  return surface;
}

}  // namespace fairing::height_field
