// SPDX-License-Identifier: LGPL-2.1-or-later
#include "benchmarks/occt_fillings.h"

#include <Adaptor3d_CurveOnSurface.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepOffsetAPI_MakeFilling.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomFill_BoundWithSurf.hxx>
#include <GeomFill_ConstrainedFilling.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>

namespace fairing::benchmarks {
namespace {

constexpr double kGapTolerance = 1e-4;    // mm, as in OpenCASCADE's own samples
constexpr double kAngleTolerance = 1e-2;  // rad

Handle(GeomFill_Boundary) boundOf(const OcctSide& side) {
  double first = 0.0;
  double last = 0.0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(side.edge, side.face, first, last);
  const Handle(Geom2dAdaptor_Curve) trimmed = new Geom2dAdaptor_Curve(curve, first, last);
  const Handle(BRepAdaptor_Surface) surface = new BRepAdaptor_Surface(side.face);
  return new GeomFill_BoundWithSurf(
      Adaptor3d_CurveOnSurface(trimmed, surface), kGapTolerance, kAngleTolerance);
}

}  // namespace

TopoDS_Shape makeFilling(const std::vector<OcctSide>& sides) {
  try {
    BRepOffsetAPI_MakeFilling filling;
    for (const OcctSide& side : sides) filling.Add(side.edge, side.face, GeomAbs_G1);
    filling.Build();
    return filling.IsDone() ? filling.Shape() : TopoDS_Shape();
  } catch (const Standard_Failure&) {
    return {};
  }
}

bool suitsConstrainedFilling(const std::vector<OcctSide>& sides) {
  return sides.size() == 3 || sides.size() == 4;
}

TopoDS_Shape constrainedFilling(const std::vector<OcctSide>& sides) {
  if (!suitsConstrainedFilling(sides)) return {};
  try {
    GeomFill_ConstrainedFilling filling(8, 15);
    if (sides.size() == 3) {
      filling.Init(boundOf(sides[0]), boundOf(sides[1]), boundOf(sides[2]));
    } else {
      filling.Init(boundOf(sides[0]), boundOf(sides[1]), boundOf(sides[2]), boundOf(sides[3]));
    }
    const Handle(Geom_BSplineSurface) surface = filling.Surface();
    if (surface.IsNull()) return {};
    return BRepBuilderAPI_MakeFace(surface, kGapTolerance).Shape();
  } catch (const Standard_Failure&) {
    return {};
  }
}

}  // namespace fairing::benchmarks
