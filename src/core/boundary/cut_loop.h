// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/base/result.h"
#include "core/boundary/boundary_loop.h"

namespace fairing::boundary {

/// A place on a loop: parameter t in [0, 1) of side `side`; 1 at the end of an open chain.
struct LoopPlace {
  std::size_t side = 0;
  double t = 0.0;
};

[[nodiscard]] Eigen::Vector3d pointAt(const BoundaryLoop& loop, const LoopPlace& place);

/// The place of a loop's sides that is nearest to a point: to a rounding where a side is smooth and
/// the point close to it.
[[nodiscard]] LoopPlace nearestPlace(const BoundaryLoop& loop, const Eigen::Vector3d& point);

/// The stretch [from, to] of an edge, and the stretch [start, end] of the new side it became.
struct Stretch {
  std::size_t edge = 0;  ///< position among the sides of the loop that was cut
  double from = 0.0, to = 1.0;
  double start = 0.0, end = 1.0;
};

/// The stretches of a chain of a loop from one place to another in its direction; all round where
/// the two are one.
[[nodiscard]] std::vector<Stretch> stretchesBetween(const BoundaryLoop& loop,
                                                    LoopPlace from,
                                                    LoopPlace to);

/// A loop cut into new sides, each from one cut to the next.
struct CutLoop {
  BoundaryLoop loop;
  std::vector<std::vector<Stretch>> stretches;  ///< of every new side, in its direction
};

/// Cuts a loop at places given in its order, two at least in every chain, chain by chain: within
/// closed ones from any place on, new side k starting at cuts[k]; open ones from end to end. Sides
/// are those of sideOfStretches() (edge_chain.h). Fails with the codes of makeLoop().
[[nodiscard]] Result<CutLoop> cutLoop(const BoundaryLoop& loop,
                                      const std::vector<LoopPlace>& cuts,
                                      int mostPoles);

}  // namespace fairing::boundary
