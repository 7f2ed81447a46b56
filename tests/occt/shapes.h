// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "core/boundary/boundary_loop.h"
#include "occt/shape_index.h"

/// Shapes with holes for the tests, made by the kernel itself.
namespace fairing::testing {

/// A cell of a grid over a surface: (column along u, row along v).
using Cell = std::pair<int, int>;

enum class Joint { Sewn, Loose };

/// Faces over the cells between the breaks, without the cells left out: sewn to a shell, or loose
/// in a compound.
[[nodiscard]] TopoDS_Shape grid(const Handle(Geom_Surface) & surface,
                                const std::vector<double>& u,
                                const std::vector<double>& v,
                                const std::set<Cell>& without,
                                Joint joint = Joint::Sewn);

/// A bicubic B-spline over [0, 30] x [0, 30], z = f(x, y) interpolated on a 10 x 10 grid.
[[nodiscard]] Handle(Geom_Surface) sheet(const std::function<double(double, double)>& f);
/// The sheet the tests share: gently waved.
[[nodiscard]] Handle(Geom_Surface) wavedSheet();
/// 3 x 3 faces of the waved sheet without the middle one: a hole of four polynomial sides.
[[nodiscard]] TopoDS_Shape sheetWithHole(Joint joint = Joint::Sewn);

/// A flat face.
[[nodiscard]] TopoDS_Shape polygon(const std::vector<Eigen::Vector3d>& corners);
[[nodiscard]] TopoDS_Shape box(double dx, double dy, double dz);
/// A box over a square with a hole through the middle of it.
[[nodiscard]] TopoDS_Shape drilledBox(double side, double height, double radius);
/// The shape's faces in a compound, each one on its own, every second one reversed.
[[nodiscard]] TopoDS_Shape everySecondReversed(const TopoDS_Shape& shape);
[[nodiscard]] TopoDS_Shape compound(const std::vector<TopoDS_Shape>& shapes);

/// Numbers of the edges that lie nearest to the given points, in that order.
[[nodiscard]] std::vector<int> edgesNear(const occt::ShapeIndex& index,
                                         const std::vector<Eigen::Vector3d>& points);
/// Numbers of the edges around the middle cell of sheetWithHole() and grids alike: one face, in the
/// middle of the shape.
[[nodiscard]] std::vector<int> innerFreeEdges(const occt::ShapeIndex& index);

[[nodiscard]] double volume(const TopoDS_Shape& shape);
[[nodiscard]] double area(const TopoDS_Shape& shape);
/// The largest tolerance of any edge or vertex.
[[nodiscard]] double largestTolerance(const TopoDS_Shape& shape);

/// Edge numbers of a loop in its order.
[[nodiscard]] std::vector<int> edgesOf(const boundary::BoundaryLoop& loop);

}  // namespace fairing::testing
