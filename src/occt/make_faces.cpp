// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/make_faces.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Face.hxx>

#include "occt/check_shape.h"
#include "occt/from_occt.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

TColStd_Array1OfReal distinctKnots(const spline::KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  TColStd_Array1OfReal result(1, int(breaks.size()));
  for (std::size_t i = 0; i < breaks.size(); ++i) result.SetValue(int(i) + 1, breaks[i]);
  return result;
}

TColStd_Array1OfInteger multiplicities(const spline::KnotVector& knots) {
  const std::vector<int> all = knots.multiplicities();
  TColStd_Array1OfInteger result(1, int(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) result.SetValue(int(i) + 1, all[i]);
  return result;
}

Handle(Geom_BSplineSurface) toSurface(const spline::BsplineSurface& patch) {
  TColgp_Array2OfPnt poles(1, patch.u.poleCount(), 1, patch.v.poleCount());
  for (int i = 0; i < patch.u.poleCount(); ++i) {
    for (int j = 0; j < patch.v.poleCount(); ++j) {
      poles.SetValue(i + 1, j + 1, toPoint(patch.pole(i, j)));
    }
  }
  return new Geom_BSplineSurface(poles,
                                 distinctKnots(patch.u),
                                 distinctKnots(patch.v),
                                 multiplicities(patch.u),
                                 multiplicities(patch.v),
                                 patch.u.degree(),
                                 patch.v.degree());
}

}  // namespace

Result<TopoDS_Shape> makeFaces(const FillResult& fill) {
  return guarded([&]() -> Result<TopoDS_Shape> {
    std::vector<TopoDS_Shape> faces;
    for (std::size_t i = 0; i < fill.patches.size(); ++i) {
      BRepBuilderAPI_MakeFace maker(toSurface(fill.patches[i]), Precision::Confusion());
      if (!maker.IsDone()) {
        return fail({.code = ErrorCode::ResultInvalid, .detail = "a patch has no border"});
      }
      TopoDS_Shape face = maker.Face();
      if (fill.reversed[i]) face.Reverse();
      if (const auto error = checkShape(face)) return fail(*error);
      faces.push_back(face);
    }
    if (faces.size() == 1) return faces.front();
    BRepBuilderAPI_Sewing sewing(Precision::Confusion());
    for (const TopoDS_Shape& face : faces) sewing.Add(face);
    sewing.Perform();
    return sewing.SewedShape();
  });
}

}  // namespace fairing::occt
