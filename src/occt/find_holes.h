// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "occt/shape_index.h"

namespace fairing::occt {

/// A loop of free edges.
struct Hole {
  std::vector<int> edges;      ///< FreeCAD's numbers, in order
  bool isOuterBorder = false;  ///< the rim of an open sheet rather than a hole in it
};

/// Every loop of free edges, by ascending lowest edge. A loop whose walk is ambiguous or does not
/// close is left out. The outer border is the loop that is about as large as its sheet and larger
/// than every other loop of that sheet; or the only loop of a sheet that lies within it, which the
/// loop shows by turning right all round, seen against the normals with the hole to the left (an
/// open box or half a sphere has a hole, not a border).
[[nodiscard]] std::vector<Hole> findHoles(const ShapeIndex& index);

}  // namespace fairing::occt
