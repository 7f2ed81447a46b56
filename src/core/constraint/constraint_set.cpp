// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/constraint_set.h"

#include <array>

#include "core/constraint/curvature_rows.h"
#include "core/constraint/seam_curvature.h"
#include "core/constraint/seam_ties.h"
#include "core/constraint/tangent_plane.h"

namespace fairing::constraint {
namespace {

using Edges = std::array<std::optional<ConstrainedEdge>, 4>;

using End = ConstrainedEdge::End;

Edges constrainedEdges(const boundary::BoundaryLoop& loop,
                       const layout::LayoutPatch& patch,
                       bool closed) {
  const auto endAt = [&](std::size_t side) {
    if (closed) return End::Closed;
    const boundary::Corner& corner = loop.corners[side];
    return corner.apart ? End::Free : corner.crease ? End::Crease : End::Held;
  };
  Edges edges;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!patch.edges[k]) continue;
    const auto which = static_cast<layout::PatchEdge>(k);
    const auto side = static_cast<std::size_t>(patch.edges[k]->side);
    edges[k] = ConstrainedEdge{&loop.sides[side],
                               &*patch.edges[k],
                               layout::edgeKnots(patch, which),
                               layout::edgePoints(patch, which, 0),
                               layout::edgePoints(patch, which, 1),
                               endAt(loop.previous(side)),
                               endAt(side)};
  }
  return edges;
}

void fixOuterRow(const ConstrainedEdge& edge, ConstraintSet& set) {
  for (std::size_t i = 0; i < edge.outer.size(); ++i) {
    set.fixed[static_cast<std::size_t>(edge.outer[i])] = 1;
    set.values.row(edge.outer[i]) = edge.use->curve.poles.row(static_cast<Eigen::Index>(i));
  }
}

// Where an edge of a patch meets the next one of the loop: in a corner of the same patch, or at the
// end of a seam.
struct Meeting {
  const ConstrainedEdge* before = nullptr;
  const ConstrainedEdge* after = nullptr;
  bool samePatch = false;
};

std::vector<Meeting> meetings(const boundary::BoundaryLoop& loop,
                              const std::vector<Edges>& patches) {
  std::vector<Meeting> result(loop.sides.size());
  std::vector<std::size_t> patchOf(loop.sides.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const auto& edge : patches[p]) {
      if (!edge) continue;
      const auto side = static_cast<std::size_t>(edge->use->side);
      result[side].before = &*edge;
      result[loop.previous(side)].after = &*edge;
      patchOf[side] = p;
    }
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k].samePatch = patchOf[k] == patchOf[loop.next(k)];
  return result;
}

// Sides and seams ask for curvature in one block: they share points.
std::optional<solver::ConstraintBlock> curvatureOf(const layout::PatchLayout& layout,
                                                   const std::vector<Edges>& patches,
                                                   const solver::Points& about) {
  auto sides = curvatureRows(layout, patches, about);
  auto seams = seamCurvatureRows(layout, about);
  if (!sides || !seams) return sides ? sides : seams;
  sides->rows.insert(sides->rows.end(), seams->rows.begin(), seams->rows.end());
  sides->solvedFor.insert(sides->solvedFor.end(), seams->solvedFor.begin(), seams->solvedFor.end());
  return sides;
}

}  // namespace

Result<ConstraintSet> constrainSides(const boundary::BoundaryLoop& loop,
                                     const layout::PatchLayout& layout,
                                     const solver::Points* about) {
  ConstraintSet set;
  set.fixed.assign(static_cast<std::size_t>(layout.pointCount), 0);
  set.values.setZero(layout.pointCount, 3);
  std::vector<Edges> patches;
  for (const layout::LayoutPatch& patch : layout.patches)
    patches.push_back(constrainedEdges(loop, patch, layout.closed));
  for (const Edges& edges : patches)
    for (const auto& edge : edges)
      if (edge) fixOuterRow(*edge, set);
  const std::vector<Meeting> all = meetings(loop, patches);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Meeting& m = all[k];
    if (loop.corners[k].apart) continue;
    auto block = m.samePatch ? cornerTwist(*m.before, *m.after)
                             : splitTangency(*m.before, *m.after, loop.corners[k]);
    if (block) set.blocks.push_back(std::move(*block));
  }
  for (const Edges& edges : patches)
    for (const auto& edge : edges) {
      if (!edge || !edge->isTangent()) continue;
      auto rows = tangentRows(*edge);
      if (!rows) return tl::unexpected<Error>(rows.error());
      set.blocks.push_back(std::move(*rows));
    }
  if (about)
    if (auto rows = curvatureOf(layout, patches, *about)) set.blocks.push_back(std::move(*rows));
  set.ties = layout.closed ? tieClosing(layout.patches.front()) : tieSeams(layout);
  return set;
}

}  // namespace fairing::constraint
