// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <TopoDS_Shape.hxx>
#include <functional>

#include "core/base/result.h"
#include "core/energy/guidance.h"

namespace fairing::occt {

/// The nearest point of the faces and the unit normal there, with weights 1; with weights 0 where
/// the faces end before they come below or above the point. Fails with ShapeEmpty
/// where there is no face. May be called by several threads at once.
[[nodiscard]] Result<std::function<energy::GuidanceSample(const Eigen::Vector3d&)>> referenceOn(
    const TopoDS_Shape& faces);

}  // namespace fairing::occt
