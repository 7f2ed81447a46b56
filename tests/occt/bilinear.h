// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Geom_BSplineSurface.hxx>

#include "core/spline/bspline_surface.h"
#include "occt/to_geom.h"

namespace fairing::testing {

/// The bilinear surface over the unit square with these corners, (0, 0), (0, 1), (1, 0) and (1, 1).
inline Handle(Geom_Surface) bilinear(const Eigen::Vector3d& p00,
                                     const Eigen::Vector3d& p01,
                                     const Eigen::Vector3d& p10,
                                     const Eigen::Vector3d& p11) {
  spline::Poles poles(4, 3);
  poles << p00.transpose(), p01.transpose(), p10.transpose(), p11.transpose();
  return occt::toSurface({spline::KnotVector::bezier(1), spline::KnotVector::bezier(1), poles});
}

}  // namespace fairing::testing
