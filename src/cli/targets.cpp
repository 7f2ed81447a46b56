// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/targets.h"

#include "occt/fill_all.h"

namespace fairing::cli {

Result<std::vector<occt::Picks>> targets(const occt::ShapeIndex& index,
                                         const occt::Picks& picks,
                                         bool outerBorders) {
  if (!picks.edges.empty() || !picks.faces.empty()) return std::vector{picks};
  return occt::chooseHoles(index,
                           {.outerBorders = outerBorders,
                            .continuity = picks.continuity,
                            .edgeContinuity = picks.edgeContinuity,
                            .directions = picks.directions});
}

}  // namespace fairing::cli
