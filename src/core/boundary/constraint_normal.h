// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>

#include "core/boundary/ribbon.h"

namespace fairing::boundary {

/// The support normal as a patch through the edge can meet it: made perpendicular to the edge,
/// since CAD edges lie a tolerance off their faces and a patch that contains the edge cannot turn
/// its normal into the edge's direction. Unit length; NaN where the support is singular. t in [0,
/// 1].
[[nodiscard]] Eigen::Vector3d constraintNormal(const Ribbon& ribbon, double t);

/// Its derivative with respect to t at the start (t = 0) or the end (t = 1), by one-sided
/// differences of fourth order.
[[nodiscard]] Eigen::Vector3d constraintNormalDerivativeAtEnd(const Ribbon& ribbon, bool atStart);

}  // namespace fairing::boundary
