// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "benchmarks/holes.h"

namespace fairing::benchmarks {

/// Holes of one, three, five and six sides: an octant of a sphere, a triangle, a pentagon, a
/// hexagon and a circle cut out of a wavy sheet, and a suitcase corner, where fillets of three
/// radii end short of each other.
[[nodiscard]] std::vector<Hole> manySidedHoles();

}  // namespace fairing::benchmarks
