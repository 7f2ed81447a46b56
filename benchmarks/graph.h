// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <gp_Pnt.hxx>

namespace fairing::benchmarks {

/// z = height(x, y) over [-1, 1]^2, interpolated on a grid, with 50 mm to the unit.
[[nodiscard]] Handle(Geom_Surface) graph(const std::function<double(double x, double y)>& height);

/// FreeCAD's number of the free edge whose middle lies nearest to a point.
[[nodiscard]] int freeEdgeAt(const TopoDS_Shape& shape, const gp_Pnt& point);

}  // namespace fairing::benchmarks
