// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/shapes.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>

#include "occt/edge_curve.h"
#include "occt/find_holes.h"
#include "occt/from_occt.h"

namespace fairing::testing {

TopoDS_Shape compound(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound result;
  const BRep_Builder builder;
  builder.MakeCompound(result);
  for (const TopoDS_Shape& shape : shapes) builder.Add(result, shape);
  return result;
}

TopoDS_Shape grid(const Handle(Geom_Surface) & surface,
                  const std::vector<double>& u,
                  const std::vector<double>& v,
                  const std::set<Cell>& without,
                  Joint joint) {
  std::vector<TopoDS_Shape> faces;
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    for (std::size_t j = 0; j + 1 < v.size(); ++j) {
      if (without.contains({int(i), int(j)})) continue;
      faces.push_back(
          BRepBuilderAPI_MakeFace(surface, u[i], u[i + 1], v[j], v[j + 1], 1e-7).Shape());
    }
  }
  if (joint == Joint::Loose) return compound(faces);
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const TopoDS_Shape& face : faces) sewing.Add(face);
  sewing.Perform();
  return sewing.SewedShape();
}

Handle(Geom_Surface) sheet(const std::function<double(double, double)>& f) {
  constexpr int kPoints = 10;
  TColgp_Array2OfPnt points(1, kPoints, 1, kPoints);
  for (int i = 1; i <= kPoints; ++i) {
    for (int j = 1; j <= kPoints; ++j) {
      const double x = 30.0 * (i - 1) / (kPoints - 1);
      const double y = 30.0 * (j - 1) / (kPoints - 1);
      points.SetValue(i, j, gp_Pnt(x, y, f(x, y)));
    }
  }
  GeomAPI_PointsToBSplineSurface fit;
  fit.Interpolate(points);
  return Handle(Geom_Surface)(fit.Surface());
}

Handle(Geom_Surface) wavedSheet() {
  return sheet([](double x, double y) { return 2.0 * std::sin(0.12 * x) * std::cos(0.09 * y); });
}

TopoDS_Shape sheetWithHole(Joint joint) {
  const Handle(Geom_Surface) surface = wavedSheet();
  double u0, u1, v0, v1;
  surface->Bounds(u0, u1, v0, v1);
  // Off the knots, yet by no hair: a span of 1e-4 would cost digits.
  const auto parts = [](double a, double b) {
    return std::vector{a, a + 0.3 * (b - a), a + 0.7 * (b - a), b};
  };
  return grid(surface, parts(u0, u1), parts(v0, v1), {{1, 1}}, joint);
}

TopoDS_Shape polygon(const std::vector<Eigen::Vector3d>& corners) {
  BRepBuilderAPI_MakePolygon wire;
  for (const Eigen::Vector3d& corner : corners) wire.Add(occt::toPoint(corner));
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire()).Face();
}

TopoDS_Shape box(double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(dx, dy, dz).Shape();
}

TopoDS_Shape drilledBox(double side, double height, double radius) {
  const gp_Ax2 axis(gp_Pnt(0.5 * side, 0.5 * side, -1.0), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(box(side, side, height),
                         BRepPrimAPI_MakeCylinder(axis, radius, height + 2.0).Shape())
      .Shape();
}

TopoDS_Shape everySecondReversed(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_FACE, map);
  std::vector<TopoDS_Shape> faces;
  for (int i = 1; i <= map.Extent(); ++i) faces.push_back(i % 2 == 0 ? map(i).Reversed() : map(i));
  return compound(faces);
}

std::vector<int> edgesNear(const occt::ShapeIndex& index,
                           const std::vector<Eigen::Vector3d>& points) {
  std::vector<int> result;
  for (const Eigen::Vector3d& point : points) {
    int nearest = 0;
    double least = 1e300;
    for (int edge = 1; edge <= index.edgeCount(); ++edge) {
      if (BRep_Tool::Degenerated(index.edge(edge))) continue;
      const occt::EdgeCurve curve(index.edge(edge), occt::Direction::Forward);
      const double distance = (curve.point(0.5) - point).norm();
      if (distance < least) {
        least = distance;
        nearest = edge;
      }
    }
    result.push_back(nearest);
  }
  return result;
}

std::vector<int> innerFreeEdges(const occt::ShapeIndex& index) {
  for (const occt::Hole& hole : occt::findHoles(index)) {
    if (!hole.isOuterBorder) return hole.edges;
  }
  return {};
}

double volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-9);
  return properties.Mass();
}

double area(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties, 1e-9);
  return properties.Mass();
}

double largestTolerance(const TopoDS_Shape& shape) {
  double largest = 0.0;
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, map);
  for (int i = 1; i <= map.Extent(); ++i) {
    if (map(i).ShapeType() == TopAbs_EDGE) {
      largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(map(i))));
    } else if (map(i).ShapeType() == TopAbs_VERTEX) {
      largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Vertex(map(i))));
    }
  }
  return largest;
}

std::vector<int> edgesOf(const boundary::BoundaryLoop& loop) {
  std::vector<int> edges;
  for (const boundary::BoundarySide& side : loop.sides) edges.push_back(side.edge);
  return edges;
}

}  // namespace fairing::testing
