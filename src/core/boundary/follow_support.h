// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/boundary/boundary_loop.h"

namespace fairing::boundary {

/// CAD edges lie off their own faces, by up to 1e-4 of their size, and wave about them: where the
/// edge's tangent leaves the face's tangent plane no patch through the edge is tangent to the face.
/// Such sides are moved towards their feet on the face, by the smallest common share of the way
/// after which what is left is within `angle` degrees inside and `cornerAngle` next to the corners.
/// A side is left alone where its tangent is within these already, where the way would be longer
/// than 1e-4 of the loop (the edge and the face then contradict each other, and the edge counts),
/// and where an end would move, since its neighbour ends there too.
/// The result is what patches are made for; what they are measured against stays the loop itself.
[[nodiscard]] BoundaryLoop followSupports(const BoundaryLoop& loop,
                                          double angle,
                                          double cornerAngle);

}  // namespace fairing::boundary
