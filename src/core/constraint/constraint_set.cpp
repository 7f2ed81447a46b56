// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/constraint_set.h"

#include <array>

#include "core/constraint/tangent_plane.h"

namespace fairing::constraint {
namespace {

using Edges = std::array<std::optional<ConstrainedEdge>, 4>;

Edges constrainedEdges(const boundary::BoundaryLoop& loop, const layout::LayoutPatch& patch) {
  Edges edges;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!patch.edges[k]) continue;
    const auto which = static_cast<layout::PatchEdge>(k);
    edges[k] = ConstrainedEdge{&loop.sides[static_cast<std::size_t>(patch.edges[k]->side)],
                               &*patch.edges[k],
                               layout::edgeKnots(patch, which),
                               layout::edgePoints(patch, which, 0),
                               layout::edgePoints(patch, which, 1)};
  }
  return edges;
}

void fixOuterRow(const ConstrainedEdge& edge, ConstraintSet& set) {
  for (std::size_t i = 0; i < edge.outer.size(); ++i) {
    set.fixed[static_cast<std::size_t>(edge.outer[i])] = 1;
    set.values.row(edge.outer[i]) = edge.use->curve.poles.row(static_cast<Eigen::Index>(i));
  }
}

Result<void> constrainPatch(const Edges& edges, ConstraintSet& set) {
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& before = edges[k];
    const auto& after = edges[(k + 1) % 4];
    if (!before || !after) continue;
    auto twist = cornerTwist(*before, *after);
    if (!twist) return tl::unexpected<Error>(twist.error());
    if (*twist) set.blocks.push_back(std::move(**twist));
  }
  for (const auto& edge : edges) {
    if (!edge || !edge->isTangent()) continue;
    auto rows = tangentRows(*edge);
    if (!rows) return tl::unexpected<Error>(rows.error());
    set.blocks.push_back(std::move(*rows));
  }
  return {};
}

}  // namespace

Result<ConstraintSet> constrainSides(const boundary::BoundaryLoop& loop,
                                     const layout::PatchLayout& layout) {
  ConstraintSet set;
  set.fixed.assign(static_cast<std::size_t>(layout.pointCount), 0);
  set.values.setZero(layout.pointCount, 3);
  for (const layout::LayoutPatch& patch : layout.patches) {
    const Edges edges = constrainedEdges(loop, patch);
    for (const auto& edge : edges)
      if (edge) fixOuterRow(*edge, set);
    if (const auto done = constrainPatch(edges, set); !done)
      return tl::unexpected<Error>(done.error());
  }
  return set;
}

}  // namespace fairing::constraint
