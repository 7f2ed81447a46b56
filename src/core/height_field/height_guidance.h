// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/energy/guidance.h"
#include "core/height_field/height_system.h"
#include "core/height_field/plane_frame.h"
#include "core/height_field/projected_loop.h"

namespace fairing::height_field {

/// Adds what guides the surface inside the loop, looked up near the height `about`:
///   lambda [(R_u . N)^2 + (R_v . N)^2] + gamma (R - S)^2      [WuYang2015] eq. 1 and 2.
/// R = (u, v, h) is linear in h, and of R - S only the height can change. Splines and grids of
/// guidance lie over the rectangle of the surface's parameters.
void addGuidance(HeightSystem& system,
                 const energy::Guidance& guidance,
                 const Heights& about,
                 const PlaneFrame& frame,
                 const ProjectedLoop& loop);

}  // namespace fairing::height_field
