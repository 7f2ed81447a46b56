// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/targets.h"

#include "occt/find_holes.h"
#include "occt/guarded.h"

namespace fairing::cli {

Result<std::vector<occt::Picks>> targets(const occt::ShapeIndex& index, const occt::Picks& picks) {
  if (!picks.edges.empty() || !picks.faces.empty()) return std::vector{picks};
  return occt::guarded([&]() -> Result<std::vector<occt::Picks>> {
    std::vector<occt::Picks> result;
    auto wishes = picks.edgeContinuity;
    for (const occt::Hole& hole : occt::findHoles(index)) {
      if (hole.isOuterBorder) continue;
      occt::Picks one{
          .edges = hole.edges, .faces = {}, .continuity = picks.continuity, .edgeContinuity = {}};
      for (int edge : hole.edges) {
        if (auto wish = wishes.extract(edge)) one.edgeContinuity.insert(std::move(wish));
      }
      result.push_back(std::move(one));
    }
    if (result.empty()) return fail({.code = ErrorCode::NothingPicked});
    if (!wishes.empty())
      return fail({.code = ErrorCode::EdgeNotInLoop, .edge = wishes.begin()->first});
    return result;
  });
}

}  // namespace fairing::cli
