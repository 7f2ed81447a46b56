// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/boundary/boundary_loop.h"
#include "core/constraint/inner_constraint.h"
#include "occt/shape_index.h"

/// What a fill must pass through, out of points, edges and vertices. Curves hold on to the shape's
/// geometry and must not be evaluated by two threads at once.
namespace fairing::occt {

[[nodiscard]] InnerConstraint throughPoint(const Eigen::Vector3d& point);

/// Edges and vertices of a shape by FreeCAD's numbers, in the order given, edges first. Fails with
/// EdgeOutOfRange or VertexOutOfRange.
[[nodiscard]] Result<std::vector<InnerConstraint>> throughParts(const ShapeIndex& index,
                                                                const std::vector<int>& edges,
                                                                const std::vector<int>& vertices);

/// Every edge of a shape and every vertex that no edge ends at. Fails with ShapeEmpty where there
/// is neither.
[[nodiscard]] Result<std::vector<InnerConstraint>> throughShape(const TopoDS_Shape& shape);

/// InnerConstraintOff for a point or curve that is nowhere closer to the loop than the loop is
/// large, or NotFinite.
[[nodiscard]] std::optional<Error> checkThrough(const boundary::BoundaryLoop& loop,
                                                const std::vector<InnerConstraint>& through);

}  // namespace fairing::occt
