// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/energy/guidance.h"

namespace fairing::energy {

/// The guidance's field alone, turned and mirrored so that its corners come to lie on the corners
/// of the patch that are nearest to them; as it is where it names no corners. Of the eight ways to
/// lay a square on a square the one whose three corners are nearest is taken. Weights stay.
[[nodiscard]] Guidance laidOn(const Guidance& guidance, const spline::BsplineSurface& patch);

}  // namespace fairing::energy
