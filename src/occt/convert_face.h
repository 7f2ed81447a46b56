// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>

#include "core/spline/bspline_surface.h"

namespace fairing::occt {

/// A face's surface as a polynomial B-spline.
struct ConvertedSurface {
  spline::BsplineSurface surface;  ///< over the bounds of the face in the surface's parameters
  double deviation = 0.0;          ///< largest distance from the face's own at equal parameters, mm
};

/// The kernel's clamped polynomial B-spline as the core's, pole by pole.
[[nodiscard]] spline::BsplineSurface fromSurface(const Geom_BSplineSurface& surface);

/// Polynomial B-splines, Bezier surfaces and planes are taken over exactly; all others are
/// approximated to a millionth of the face's size, parameters kept. Throws what the kernel throws.
[[nodiscard]] ConvertedSurface convertSurface(const TopoDS_Face& face);

/// The same border on another surface with the same parameters: edges keep their curves in space
/// and in the parameters; tolerances grow by `deviation`. The orientation is the face's.
[[nodiscard]] TopoDS_Face onSurface(const TopoDS_Face& face,
                                    const spline::BsplineSurface& surface,
                                    double deviation);

}  // namespace fairing::occt
