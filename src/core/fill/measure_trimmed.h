// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/fill/fill_hole.h"
#include "core/height_field/projected_loop.h"

namespace fairing {

/// A hole seen over a plane: the loop as it is, which the result is measured against, and the one
/// the surface is made for.
struct TrimmedHole {
  const boundary::BoundaryLoop& loop;
  boundary::BoundaryLoop target;
  analysis::LoopProbe probe;
  height_field::PlaneFrame frame;
  height_field::ProjectedLoop projected;
};

/// InnerConstraintOff for the first constraint that lies farther from the loop than it is large.
[[nodiscard]] std::optional<Error> farInnerConstraint(const TrimmedHole& hole,
                                                      const std::vector<InnerConstraint>& through);

/// One surface over the hole's plane, with everything measured on it but the fairness.
[[nodiscard]] FillResult measureTrimmed(const TrimmedHole& hole,
                                        spline::BsplineSurface surface,
                                        const FillOptions& options);

/// Area and curvature integrals of what lies inside the loop.
[[nodiscard]] analysis::FairnessReport trimmedFairness(const TrimmedHole& hole,
                                                       const spline::BsplineSurface& surface);

}  // namespace fairing
