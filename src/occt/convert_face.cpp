// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/convert_face.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <GeomConvert_ApproxSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "occt/from_occt.h"
#include "occt/to_geom.h"

namespace fairing::occt {
namespace {

/// What cannot be taken over is approximated to this share of the face's size.
constexpr double kFit = 1e-6;
constexpr int kFitDegree = 8, kFitSpans = 100;
/// Bounds this close to the surface's own, as a share of them, are the surface's own: files keep 15
/// digits.
constexpr double kSameBound = 1e-12;
constexpr int kChecks = 41;
/// What rounding may add to a measured tolerance.
constexpr double kBeyond = 1.001;

struct Bounds {
  double u0, u1, v0, v1;
};

Handle(Geom_Surface) basisOf(Handle(Geom_Surface) surface) {
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
    surface = trimmed->BasisSurface();
  return surface;
}

spline::KnotVector knotsOf(int degree, const TColStd_Array1OfReal& sequence) {
  return {degree, std::vector<double>(sequence.begin(), sequence.end())};
}

bool isWithin(const Bounds& inner, const Geom_BSplineSurface& surface) {
  double u0, u1, v0, v1;
  surface.Bounds(u0, u1, v0, v1);
  const double du = kSameBound * (u1 - u0), dv = kSameBound * (v1 - v0);
  return inner.u0 >= u0 - du && inner.u1 <= u1 + du && inner.v0 >= v0 - dv && inner.v1 <= v1 + dv;
}

/// The stretch of a polynomial B-spline within bounds, clamped.
Handle(Geom_BSplineSurface) cut(const Handle(Geom_BSplineSurface) & spline, const Bounds& to) {
  double u0, u1, v0, v1;
  spline->Bounds(u0, u1, v0, v1);
  const auto snapped = [](double value, double bound, double range) {
    return std::abs(value - bound) <= kSameBound * range ? bound : value;
  };
  const Bounds ends{snapped(to.u0, u0, u1 - u0),
                    snapped(to.u1, u1, u1 - u0),
                    snapped(to.v0, v0, v1 - v0),
                    snapped(to.v1, v1, v1 - v0)};
  const auto isClamped = [](int multiplicity, int degree) { return multiplicity == degree + 1; };
  const bool whole = ends.u0 == u0 && ends.u1 == u1 && ends.v0 == v0 && ends.v1 == v1 &&
                     isClamped(spline->UMultiplicity(1), spline->UDegree()) &&
                     isClamped(spline->UMultiplicity(spline->NbUKnots()), spline->UDegree()) &&
                     isClamped(spline->VMultiplicity(1), spline->VDegree()) &&
                     isClamped(spline->VMultiplicity(spline->NbVKnots()), spline->VDegree());
  if (!whole)
    spline->Segment(
        ends.u0, ends.u1, ends.v0, ends.v1, kSameBound * (u1 - u0), kSameBound * (v1 - v0));
  return spline;
}

spline::BsplineSurface planeWithin(const Geom_Surface& plane, const Bounds& b) {
  spline::Poles poles(4, 3);
  poles << fromOcct(plane.Value(b.u0, b.v0)).transpose(),
      fromOcct(plane.Value(b.u0, b.v1)).transpose(), fromOcct(plane.Value(b.u1, b.v0)).transpose(),
      fromOcct(plane.Value(b.u1, b.v1)).transpose();
  return {spline::KnotVector::bezier(1, b.u0, b.u1),
          spline::KnotVector::bezier(1, b.v0, b.v1),
          std::move(poles)};
}

/// The surface itself as a polynomial B-spline that covers the bounds, or null.
Handle(Geom_BSplineSurface) polynomialOf(const Handle(Geom_Surface) & surface, const Bounds& b) {
  Handle(Geom_BSplineSurface) spline;
  if (const auto own = Handle(Geom_BSplineSurface)::DownCast(surface)) {
    spline = Handle(Geom_BSplineSurface)::DownCast(own->Copy());
    if (spline->IsUPeriodic()) spline->SetUNotPeriodic();
    if (spline->IsVPeriodic()) spline->SetVNotPeriodic();
  } else if (surface->IsKind(STANDARD_TYPE(Geom_BezierSurface))) {
    spline = GeomConvert::SurfaceToBSplineSurface(surface);
  }
  const bool fits =
      !spline.IsNull() && !spline->IsURational() && !spline->IsVRational() && isWithin(b, *spline);
  return fits ? spline : nullptr;
}

double sizeWithin(const Geom_Surface& surface, const Bounds& b) {
  const gp_Pnt middle = surface.Value(0.5 * (b.u0 + b.u1), 0.5 * (b.v0 + b.v1));
  double size = 0.0;
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 8; ++j)
      size = std::max(size,
                      2.0 * middle.Distance(surface.Value(b.u0 + (b.u1 - b.u0) * i / 8,
                                                          b.v0 + (b.v1 - b.v0) * j / 8)));
  return size;
}

double deviationOf(const spline::BsplineSurface& made, const Geom_Surface& from) {
  double largest = 0.0;
  for (int i = 0; i < kChecks; ++i)
    for (int j = 0; j < kChecks; ++j) {
      const double u = made.u.at(i / (kChecks - 1.0)), v = made.v.at(j / (kChecks - 1.0));
      largest = std::max(largest, (made.evaluate(u, v) - fromOcct(from.Value(u, v))).norm());
    }
  return largest;
}

}  // namespace

spline::BsplineSurface fromSurface(const Geom_BSplineSurface& surface) {
  spline::BsplineSurface result{knotsOf(surface.UDegree(), surface.UKnotSequence()),
                                knotsOf(surface.VDegree(), surface.VKnotSequence()),
                                spline::Poles(surface.NbUPoles() * surface.NbVPoles(), 3)};
  for (int i = 0; i < surface.NbUPoles(); ++i)
    for (int j = 0; j < surface.NbVPoles(); ++j)
      result.poles.row(result.index(i, j)) = fromOcct(surface.Pole(i + 1, j + 1)).transpose();
  return result;
}

ConvertedSurface convertSurface(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = basisOf(BRep_Tool::Surface(face));
  Bounds b{};
  BRepTools::UVBounds(face, b.u0, b.u1, b.v0, b.v1);
  if (surface->IsKind(STANDARD_TYPE(Geom_Plane))) return {planeWithin(*surface, b)};
  if (const auto spline = polynomialOf(surface, b); !spline.IsNull())
    return {fromSurface(*cut(spline, b))};
  const Handle(Geom_Surface) trimmed =
      new Geom_RectangularTrimmedSurface(surface, b.u0, b.u1, b.v0, b.v1);
  const GeomConvert_ApproxSurface fit(trimmed,
                                      kFit * sizeWithin(*surface, b),
                                      GeomAbs_C2,
                                      GeomAbs_C2,
                                      kFitDegree,
                                      kFitDegree,
                                      kFitSpans,
                                      0);
  ConvertedSurface result{fromSurface(*cut(fit.Surface(), b))};
  result.deviation = deviationOf(result.surface, *surface);
  return result;
}

TopoDS_Face onSurface(const TopoDS_Face& face,
                      const spline::BsplineSurface& surface,
                      double deviation) {
  const TopoDS_Face old =
      TopoDS::Face(BRepBuilderAPI_Copy(face.Oriented(TopAbs_FORWARD), false).Shape());
  const Handle(Geom_Surface) made = toSurface(surface);
  const TopLoc_Location here;
  const BRep_Builder builder;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(old, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD));
    const double tolerance = std::max(BRep_Tool::Tolerance(edge), kBeyond * deviation);
    double first, last;
    const auto curve = BRep_Tool::CurveOnSurface(edge, old, first, last);
    if (BRep_Tool::IsClosed(edge, old)) {
      const auto other = BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Reversed()), old, first, last);
      builder.UpdateEdge(edge, curve, other, made, here, tolerance);
    } else {
      builder.UpdateEdge(edge, curve, made, here, tolerance);
    }
    builder.Range(edge, made, here, first, last);
  }
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(old, TopAbs_VERTEX, vertices);
  for (int i = 1; i <= vertices.Extent(); ++i)
    builder.UpdateVertex(TopoDS::Vertex(vertices(i)), kBeyond * deviation);
  TopoDS_Face result;
  builder.MakeFace(result, made, Precision::Confusion());
  for (TopoDS_Iterator wire(old); wire.More(); wire.Next()) builder.Add(result, wire.Value());
  result.Orientation(face.Orientation());
  return result;
}

}  // namespace fairing::occt
