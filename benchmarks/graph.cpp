// SPDX-License-Identifier: LGPL-2.1-or-later
#include "benchmarks/graph.h"

#include <BRepAdaptor_Curve.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <limits>

namespace fairing::benchmarks {

Handle(Geom_Surface) graph(const std::function<double(double x, double y)>& height) {
  constexpr int kGrid = 15;
  constexpr double kScale = 50.0;
  TColgp_Array2OfPnt points(1, kGrid, 1, kGrid);
  for (int i = 1; i <= kGrid; ++i) {
    for (int j = 1; j <= kGrid; ++j) {
      const double x = 2.0 * (i - 1) / (kGrid - 1) - 1.0;
      const double y = 2.0 * (j - 1) / (kGrid - 1) - 1.0;
      points(i, j) = gp_Pnt(kScale * x, kScale * y, kScale * height(x, y));
    }
  }
  GeomAPI_PointsToBSplineSurface fit;
  fit.Interpolate(points);
  return Handle(Geom_Surface)(fit.Surface());
}

int freeEdgeAt(const TopoDS_Shape& shape, const gp_Pnt& point) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  int nearest = 0;
  double least = std::numeric_limits<double>::max();
  for (int number = 1; number <= edges.Extent(); ++number) {
    if (faces.FindFromKey(edges(number)).Extent() != 1) continue;
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges(number)));
    const double distance =
        curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter())).Distance(point);
    if (distance < least) {
      least = distance;
      nearest = number;
    }
  }
  return nearest;
}

}  // namespace fairing::benchmarks
