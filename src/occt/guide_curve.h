// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "core/base/result.h"

namespace fairing::occt {

/// Points along a curve at equal lengths, and the normal to follow at each.
struct GuideCurve {
  std::vector<Eigen::Vector3d> points, normals;
};

/// Samples of the edges of a shape, which make one curve in whatever order they are given. Normals
/// are those of the nearest faces of `faces`, where that is not null, else `direction` turned
/// square to the curve. Fails with GuideCurveBroken, GuideCurveBare where there is neither, and
/// GuideCurveAlong where the direction runs along the curve.
[[nodiscard]] Result<GuideCurve> guideCurve(const TopoDS_Shape& edges,
                                            const TopoDS_Shape& faces,
                                            const std::optional<Eigen::Vector3d>& direction);

}  // namespace fairing::occt
