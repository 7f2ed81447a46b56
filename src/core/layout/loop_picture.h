// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/boundary/boundary_loop.h"

namespace fairing::layout {

/// A planar picture of the starts of a loop's sides about its centre (the origin): distances to the
/// centre as in space, angles between neighbours in proportion to those seen from the centre, full
/// circle in all. Nothing is projected: loops may be as steep as they like. Angles between
/// neighbours stay above a fifth of the average one.
[[nodiscard]] std::vector<Eigen::Vector2d> pictureOf(const boundary::BoundaryLoop& loop);

/// The same of points round a centre.
[[nodiscard]] std::vector<Eigen::Vector2d> pictureOf(const std::vector<Eigen::Vector3d>& points,
                                                     const Eigen::Vector3d& centre);

}  // namespace fairing::layout
