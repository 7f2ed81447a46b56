// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>

#include "core/height_field/trim.h"
#include "core/spline/bspline_surface.h"

namespace fairing::occt {

/// The core's splines as the CAD kernel's, pole by pole.
[[nodiscard]] Handle(Geom_BSplineSurface) toSurface(const spline::BsplineSurface& patch);
[[nodiscard]] Handle(Geom_BSplineCurve) toCurve(const spline::BsplineCurve& curve);
/// A trim's image in the parameters.
[[nodiscard]] Handle(Geom2d_BSplineCurve) toParameterCurve(const TrimCurve& curve);

}  // namespace fairing::occt
