// SPDX-License-Identifier: LGPL-2.1-or-later
#include "benchmarks/holes.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "benchmarks/graph.h"
#include "benchmarks/many_sided_holes.h"

namespace fairing::benchmarks {
namespace {

constexpr double kSewingTolerance =
    1e-6;  // mm; the pieces are cut from one surface and fit to rounding
constexpr double kPi = std::numbers::pi;

// Cuts of a parameter range: the middle one of the three pieces is left out.
using Cuts = std::array<double, 4>;

// Three by three pieces of a surface without the one in the middle.
Hole sheet(const std::string& name,
           const Handle(Geom_Surface) & surface,
           const Cuts& u,
           const Cuts& v) {
  BRepBuilderAPI_Sewing sewing(kSewingTolerance);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (i == 1 && j == 1) continue;
      sewing.Add(
          BRepBuilderAPI_MakeFace(surface, u[i], u[i + 1], v[j], v[j + 1], kSewingTolerance));
    }
  }
  sewing.Perform();
  const TopoDS_Shape shape = sewing.SewedShape();
  return {name, shape, freeEdgeAt(shape, surface->Value(0.5 * (u[1] + u[2]), v[1]))};
}

Hole graphSheet(const std::string& name, const Handle(Geom_Surface) & surface) {
  Cuts u{};
  Cuts v{};
  surface->Bounds(u[0], u[3], v[0], v[3]);
  const auto between = [](const Cuts& cuts, double t) { return cuts[0] + t * (cuts[3] - cuts[0]); };
  u[1] = between(u, 0.3);
  u[2] = between(u, 0.7);
  v[1] = between(v, 0.35);
  v[2] = between(v, 0.65);
  return sheet(name, surface, u, v);
}

// A box whose three edges at one corner are rounded with different radii, without the face that
// joins the fillets: the B-spline or spherical face nearest to that corner.
Hole filletCorner() {
  const gp_Pnt corner(40.0, 30.0, 20.0);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0.0, 0.0, 0.0), corner);
  BRepFilletAPI_MakeFillet fillet(box);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  double radius = 4.0;
  for (int number = 1; number <= edges.Extent(); ++number) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(number));
    const BRepAdaptor_Curve curve(edge);
    if (std::min(curve.Value(curve.FirstParameter()).Distance(corner),
                 curve.Value(curve.LastParameter()).Distance(corner)) > kSewingTolerance)
      continue;
    fillet.Add(radius, edge);
    radius += 2.0;
  }
  fillet.Build();

  TopoDS_Shape joint;
  gp_Pnt middle;
  double least = std::numeric_limits<double>::max();
  for (TopExp_Explorer faces(fillet.Shape(), TopAbs_FACE); faces.More(); faces.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(faces.Current()));
    const gp_Pnt centre =
        surface.Value(0.5 * (surface.FirstUParameter() + surface.LastUParameter()),
                      0.5 * (surface.FirstVParameter() + surface.LastVParameter()));
    if (surface.GetType() == GeomAbs_Plane || centre.Distance(corner) >= least) continue;
    least = centre.Distance(corner);
    joint = faces.Current();
    middle = centre;
  }

  BRepBuilderAPI_Sewing sewing(kSewingTolerance);
  for (TopExp_Explorer faces(fillet.Shape(), TopAbs_FACE); faces.More(); faces.Next()) {
    if (!faces.Current().IsSame(joint)) sewing.Add(faces.Current());
  }
  sewing.Perform();
  return {"fillet_corner", sewing.SewedShape(), freeEdgeAt(sewing.SewedShape(), middle)};
}

}  // namespace

std::vector<Hole> makeHoles() {
  const gp_Ax3 frame;
  const Cuts turn{0.2 * kPi, 0.35 * kPi, 0.65 * kPi, 0.8 * kPi};
  const Cuts tilt{-0.35 * kPi, -0.15 * kPi, 0.15 * kPi, 0.35 * kPi};
  std::vector<Hole> holes{
      sheet("torus", new Geom_ToroidalSurface(frame, 40.0, 15.0), turn, tilt),
      sheet("sphere", new Geom_SphericalSurface(frame, 30.0), turn, tilt),
      sheet("cylinder", new Geom_CylindricalSurface(frame, 20.0), turn, {0.0, 20.0, 50.0, 70.0}),
      graphSheet("saddle", graph([](double x, double y) { return 0.3 * (x * x - y * y); })),
      graphSheet("waves", graph([](double x, double y) {
                   return 0.1 * std::sin(2.5 * x + 0.4) * std::cos(2.0 * y) + 0.05 * x * y;
                 })),
      graphSheet("bump",
                 graph([](double x, double y) { return 0.4 * std::exp(-3.0 * (x * x + y * y)); })),
      filletCorner(),
  };
  for (Hole& hole : manySidedHoles()) holes.push_back(std::move(hole));
  return holes;
}

}  // namespace fairing::benchmarks
