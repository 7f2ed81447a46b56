// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/to_geom.h"

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "occt/from_occt.h"

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

}  // namespace

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

Handle(Geom_BSplineCurve) toCurve(const spline::BsplineCurve& curve) {
  TColgp_Array1OfPnt poles(1, curve.knots.poleCount());
  for (int i = 0; i < curve.knots.poleCount(); ++i)
    poles.SetValue(i + 1, toPoint(curve.poles.row(i).transpose()));
  return new Geom_BSplineCurve(
      poles, distinctKnots(curve.knots), multiplicities(curve.knots), curve.knots.degree());
}

Handle(Geom2d_BSplineCurve) toParameterCurve(const TrimCurve& curve) {
  const spline::KnotVector& knots = curve.inSpace.knots;
  TColgp_Array1OfPnt2d poles(1, knots.poleCount());
  for (int i = 0; i < knots.poleCount(); ++i)
    poles.SetValue(i + 1, gp_Pnt2d(curve.parameters(i, 0), curve.parameters(i, 1)));
  return new Geom2d_BSplineCurve(
      poles, distinctKnots(knots), multiplicities(knots), knots.degree());
}

}  // namespace fairing::occt
