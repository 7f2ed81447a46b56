// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/seam_rows.h"

#include <algorithm>

namespace fairing::constraint {
namespace {

const layout::LayoutPatch& patchOf(const layout::PatchLayout& layout, int number) {
  return layout.patches[static_cast<std::size_t>(number)];
}

}  // namespace

std::vector<int> rowInFirst(const layout::PatchLayout& layout, const layout::Seam& seam, int row) {
  return layout::edgePoints(patchOf(layout, seam.first), seam.firstEdge, row);
}

std::vector<int> rowInSecond(const layout::PatchLayout& layout, const layout::Seam& seam, int row) {
  std::vector<int> points = layout::edgePoints(patchOf(layout, seam.second), seam.secondEdge, row);
  std::reverse(points.begin(), points.end());
  return points;
}

SeamRows seamRows(const layout::PatchLayout& layout, const layout::Seam& seam) {
  const layout::LayoutPatch &a = patchOf(layout, seam.first), &b = patchOf(layout, seam.second);
  return {&seam,
          layout::edgeKnots(a, seam.firstEdge).mapped(0.0, 1.0),
          rowInFirst(layout, seam, 0),
          rowInFirst(layout, seam, 1),
          rowInSecond(layout, seam, 1),
          layout::crossStep(a, seam.firstEdge),
          layout::crossStep(b, seam.secondEdge)};
}

}  // namespace fairing::constraint
