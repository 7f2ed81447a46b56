// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/base/tolerance.h"
#include "core/boundary/boundary_loop.h"

namespace fairing::analysis {

/// A place where a side is measured, with what the base says there. "Corner" places lie within
/// kCornerZone of the length next to an end, unless the next edge continues this one smoothly
/// there.
struct ProbePoint {
  double t = 0.0;  ///< side parameter
  bool inCorner = false;
  Eigen::Vector3d point, tangent;  ///< on the side; the tangent of unit length
  bool hasNormal = false;  ///< the support has a normal here, and this is no end of the side
  Eigen::Vector3d normal;  ///< of the support face, unit
  double curvature = 0.0;  ///< normal curvature of the support face across the side, 1/mm
  Eigen::Vector3d iso;     ///< SupportSample::iso
  /// The edge's tangent leaves the support's tangent plane by this angle, degrees: no patch through
  /// the edge comes closer.
  double floor = 0.0;
};

/// Where every side of a loop is measured: once per loop, however many patches are tried.
struct LoopProbe {
  std::vector<std::vector<ProbePoint>> sides;
};

/// How many places a side is measured at.
struct Places {
  int inside = 81;  ///< between the corner zones
  int corner = 8;   ///< in either of them
};

/// Places evenly spread over the arc length, ascending, and the two ends, which count for the gap
/// alone: a corner belongs to two sides and has the normal of neither.
/// `target` is the loop that patches are made for, of which the floor is taken
/// (boundary/follow_support.h). `starts`: the parameters from which the sides are divided, 0 but of
/// closed ones, whose own start means nothing; empty = 0 for all.
[[nodiscard]] LoopProbe probeLoop(const boundary::BoundaryLoop& loop,
                                  const boundary::BoundaryLoop& target,
                                  const std::vector<double>& starts = {},
                                  const Places& places = {});
[[nodiscard]] inline LoopProbe probeLoop(const boundary::BoundaryLoop& loop) {
  return probeLoop(loop, loop);
}

}  // namespace fairing::analysis
