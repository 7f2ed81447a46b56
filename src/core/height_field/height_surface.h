// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/height_field/height_jet.h"
#include "core/height_field/plane_frame.h"
#include "core/spline/bspline_surface.h"

namespace fairing::height_field {

/// R(u, v) = origin + unit (u a + v b + h(u, v) n), exactly: mm over the frame's coordinates.
[[nodiscard]] spline::BsplineSurface surfaceOf(const Heights& heights, const PlaneFrame& frame);

}  // namespace fairing::height_field
