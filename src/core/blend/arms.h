// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <array>

#include "core/span/span_hole.h"

namespace fairing {

/// How a strip leaves a side, in the middle of it: what a handle for its reach is drawn by.
struct Arm {
  Eigen::Vector3d point;   ///< on the side
  Eigen::Vector3d vector;  ///< a third of the cross tangent over the whole strip, mm
};

/// The arms of either side of a strip; those at reach 1 times the reach are those at that reach.
[[nodiscard]] std::array<Arm, 2> armsOf(const Patches& strip);

}  // namespace fairing
