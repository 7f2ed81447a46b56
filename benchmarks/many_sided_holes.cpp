// SPDX-License-Identifier: LGPL-2.1-or-later
#include "benchmarks/many_sided_holes.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <array>
#include <cmath>
#include <numbers>

#include "benchmarks/graph.h"

namespace fairing::benchmarks {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 1e-6;   // mm
constexpr double kHoleRadius = 20.0;  // mm, of the circle a polygon stands in
constexpr double kDepth = 100.0;      // mm, of the tools that cut the sheet, to either side

Handle(Geom_Surface) wavySheet() {
  return graph([](double x, double y) {
    return 0.12 * std::sin(2.2 * x + 0.3) * std::cos(1.8 * y) + 0.06 * x * y;
  });
}

// Three of the four upper eighths of a sphere and the lower half; the last eighth is open.
Hole sphereOctant() {
  constexpr double kRadius = 25.0;
  const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), kRadius);
  BRepBuilderAPI_Sewing sewing(kTolerance);
  for (int k = 0; k < 4; ++k) {
    const double u = 0.5 * kPi * k;
    if (k > 0)
      sewing.Add(BRepBuilderAPI_MakeFace(sphere, u, u + 0.5 * kPi, 0.0, 0.5 * kPi, kTolerance));
    sewing.Add(BRepBuilderAPI_MakeFace(sphere, u, u + 0.5 * kPi, -0.5 * kPi, 0.0, kTolerance));
  }
  sewing.Perform();
  const TopoDS_Shape& shape = sewing.SewedShape();
  return {"sphere_octant", shape, freeEdgeAt(shape, sphere->Value(0.25 * kPi, 0.0))};
}

Hole cutSheet(const std::string& name, const TopoDS_Shape& tool, const gp_Pnt& middleOfEdge) {
  const TopoDS_Shape sheet = BRepBuilderAPI_MakeFace(wavySheet(), kTolerance);
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(sheet, tool).Shape();
  return {name, shape, freeEdgeAt(shape, middleOfEdge)};
}

Hole polygonHole(const std::string& name, int corners) {
  BRepBuilderAPI_MakePolygon polygon;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * kPi * k / corners + 0.2;
    polygon.Add(gp_Pnt(kHoleRadius * std::cos(angle), kHoleRadius * std::sin(angle), -kDepth));
  }
  polygon.Close();
  const TopoDS_Shape base = BRepBuilderAPI_MakeFace(polygon.Wire());
  return cutSheet(
      name, BRepPrimAPI_MakePrism(base, gp_Vec(0.0, 0.0, 2.0 * kDepth)), gp_Pnt(0.0, 0.0, 0.0));
}

Hole roundHole() {
  const gp_Ax2 axis(gp_Pnt(0.0, 0.0, -kDepth), gp_Dir(0.0, 0.0, 1.0));
  return cutSheet("round_hole",
                  BRepPrimAPI_MakeCylinder(axis, kHoleRadius, 2.0 * kDepth),
                  gp_Pnt(0.0, 0.0, 0.0));
}

gp_Pnt point(std::size_t axis, double along, double next, double last) {
  std::array<double, 3> p{};
  p[axis] = along;
  p[(axis + 1) % 3] = next;
  p[(axis + 2) % 3] = last;
  return {p[0], p[1], p[2]};
}

// The corner of a box at the origin. The fillet along an axis touches the two planes that hold it
// and ends kEnd short of the corner; the planes are cut straight from fillet to fillet.
Hole suitcaseCorner() {
  constexpr std::array<double, 3> kRadii{3.0, 5.0, 8.0};
  constexpr double kEnd = 14.0;
  constexpr double kBox = 40.0;
  BRepBuilderAPI_Sewing sewing(kTolerance);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double here = kRadii[axis];
    const double next = kRadii[(axis + 1) % 3];
    const auto direction = point(axis, 1.0, 0.0, 0.0).XYZ();
    const auto towards = point(axis, 0.0, -1.0, 0.0).XYZ();
    const gp_Ax3 frame(point(axis, 0.0, here, here), gp_Dir(direction), gp_Dir(towards));
    sewing.Add(
        BRepBuilderAPI_MakeFace(Handle(Geom_Surface)(new Geom_CylindricalSurface(frame, here)),
                                0.0,
                                0.5 * kPi,
                                kEnd,
                                kBox,
                                kTolerance));
    // The plane of this axis and the next one.
    BRepBuilderAPI_MakePolygon border;
    border.Add(point(axis, kEnd, here, 0.0));
    border.Add(point(axis, kBox, here, 0.0));
    border.Add(point(axis, kBox, kBox, 0.0));
    border.Add(point(axis, next, kBox, 0.0));
    border.Add(point(axis, next, kEnd, 0.0));
    border.Close();
    sewing.Add(BRepBuilderAPI_MakeFace(border.Wire()));
  }
  sewing.Perform();
  const TopoDS_Shape& shape = sewing.SewedShape();
  return {"suitcase", shape, freeEdgeAt(shape, point(0, 0.5 * kEnd, 0.5 * kEnd, 0.0))};
}

}  // namespace

std::vector<Hole> manySidedHoles() {
  return {sphereOctant(),
          polygonHole("wavy_triangle", 3),
          polygonHole("wavy_pentagon", 5),
          polygonHole("wavy_hexagon", 6),
          roundHole(),
          suitcaseCorner()};
}

}  // namespace fairing::benchmarks
