// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/across.h"

#include "core/spline/bspline_basis.h"

namespace fairing::constraint {

using layout::PatchEdge;

Across acrossOf(const layout::LayoutPatch& patch, PatchEdge edge) {
  const spline::KnotVector own = layout::directionOf(edge) == 0 ? patch.v : patch.u;
  const bool farSide = edge == PatchEdge::East || edge == PatchEdge::North;
  const spline::KnotVector inward = farSide ? own.reversed() : own;
  const spline::BasisRow basis = spline::basisRow(inward, inward.first(), 2);
  Across across;
  for (int k = 0; k < 3; ++k) {
    across.first[static_cast<std::size_t>(k)] = basis.values(1, k);
    across.second[static_cast<std::size_t>(k)] = basis.values(2, k);
  }
  return across;
}

}  // namespace fairing::constraint
