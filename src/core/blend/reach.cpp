// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/reach.h"

namespace fairing {

HeldPoints heldRows(const layout::PatchLayout& layout, const Patches& patches, const Reach& reach) {
  const solver::Points points = pointsOf(layout, patches);
  const layout::LayoutPatch& patch = layout.patches.front();
  HeldPoints held;
  std::vector<Eigen::RowVector3d> values;
  for (const auto edge : {layout::PatchEdge::South, layout::PatchEdge::North}) {
    const double factor = reach[edge == layout::PatchEdge::South ? 0 : 1];
    const auto outer = layout::edgePoints(patch, edge, 0);
    const auto inner = layout::edgePoints(patch, edge, 1);
    for (std::size_t i = 0; i < inner.size(); ++i) {
      held.points.push_back(inner[i]);
      values.emplace_back(points.row(outer[i]) +
                          factor * (points.row(inner[i]) - points.row(outer[i])));
    }
  }
  held.values.resize(static_cast<Eigen::Index>(values.size()), 3);
  for (std::size_t k = 0; k < values.size(); ++k)
    held.values.row(static_cast<Eigen::Index>(k)) = values[k];
  return held;
}

}  // namespace fairing
