// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/patch_layout.h"

#include <algorithm>

namespace fairing::layout {

std::vector<int> edgePoints(const LayoutPatch& patch, PatchEdge edge, int row) {
  const int nu = patch.u.poleCount(), nv = patch.v.poleCount();
  const bool alongU = edge == PatchEdge::South || edge == PatchEdge::North;
  const bool farSide = edge == PatchEdge::East || edge == PatchEdge::North;
  const int across = farSide ? (alongU ? nv : nu) - 1 - row : row;
  std::vector<int> result;
  for (int k = 0; k < (alongU ? nu : nv); ++k) {
    const int i = alongU ? k : across, j = alongU ? across : k;
    result.push_back(patch.points[static_cast<std::size_t>(i * nv + j)]);
  }
  const bool falls = edge == PatchEdge::North || edge == PatchEdge::West;
  if (falls) std::reverse(result.begin(), result.end());
  return result;
}

spline::KnotVector edgeKnots(const LayoutPatch& patch, PatchEdge edge) {
  switch (edge) {
    case PatchEdge::South:
      return patch.u;
    case PatchEdge::East:
      return patch.v;
    case PatchEdge::North:
      return patch.u.reversed();
    case PatchEdge::West:
      break;
  }
  return patch.v.reversed();
}

}  // namespace fairing::layout
