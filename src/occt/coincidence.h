// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "occt/border_candidates.h"

/// Edges of unsewn shapes: what lies together belongs together.
namespace fairing::occt {

/// Joins ends that are separate vertices but lie within their tolerances, or within 1e-5 of the
/// size of all edges. Sets Candidate::ends to node numbers; returns the nodes' points. No edge is
/// made to collapse.
std::vector<Eigen::Vector3d> joinEnds(const ShapeIndex& index, std::vector<Candidate>& candidates);

/// Positions of candidates, those in one group coincide along their whole length. Ends must have
/// been joined.
[[nodiscard]] std::vector<std::vector<int>> groupsOfTwins(const ShapeIndex& index,
                                                          const std::vector<Candidate>& candidates);

}  // namespace fairing::occt
