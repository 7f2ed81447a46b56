// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <vector>

#include "core/height_field/height_system.h"
#include "core/height_field/projected_loop.h"

namespace fairing::height_field {

struct HeightKnots {
  spline::KnotVector u, v;
  [[nodiscard]] int poleCount() const { return u.poleCount() * v.poleCount(); }
};

/// Square cells over the loop's box and a margin, in which the loop's trim stays off the border.
[[nodiscard]] HeightKnots coarseKnots(const ProjectedLoop& loop, int degree);

/// The same with spans halved, along both directions, where rows are off by more than `aim` times
/// what is allowed; the worst first, as many as fit into maxPoles. Nothing where no row is, or none
/// fits.
[[nodiscard]] std::optional<HeightKnots> finerKnots(const HeightKnots& knots,
                                                    const Heights& heights,
                                                    const std::vector<HeightRow>& rows,
                                                    double aim,
                                                    int maxPoles);

}  // namespace fairing::height_field
