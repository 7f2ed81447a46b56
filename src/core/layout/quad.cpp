// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/quad.h"

#include <cmath>

namespace fairing::layout {
Result<LayoutPlan> quadPlan(const boundary::BoundaryLoop& loop,
                            const std::vector<CornerRole>& roles) {
  std::vector<boundary::LoopPlace> cuts;
  const std::size_t n = loop.sides.size();
  for (std::size_t k = 0; k < n; ++k)
    if (roles[(k + n - 1) % n] != CornerRole::Smooth) cuts.push_back({k, 0.0});
  if (cuts.size() != 4)
    return fail({ErrorCode::WrongSideCount, 0, 0, std::nullopt, static_cast<double>(cuts.size())});
  auto cut = boundary::cutLoop(loop, cuts, kMostPolesOfOne);
  if (!cut) return fail(cut.error());
  LayoutPlan plan{LayoutKind::Quad, std::move(*cut), {}};
  plan.mesh.quads = {{{0, 1, 2, 3}, {0, 1, 2, 3}}};
  plan.mesh.vertices.assign(4, Eigen::Vector2d::Zero());  // no seam asks for the picture
  plan.mesh.inside.assign(4, 0);
  return plan;
}

}  // namespace fairing::layout
