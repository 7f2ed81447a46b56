// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/make_faces.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TopoDS_Face.hxx>

#include "occt/check_shape.h"
#include "occt/guarded.h"
#include "occt/to_geom.h"
#include "occt/trimmed_face.h"

namespace fairing::occt {
namespace {

Result<TopoDS_Face> makeFace(const FillResult& fill, std::size_t patch) {
  const Handle(Geom_BSplineSurface) surface = toSurface(fill.patches[patch]);
  if (!fill.trims.empty()) return trimmedFace(surface, fill.trims[patch]);
  BRepBuilderAPI_MakeFace maker(surface, Precision::Confusion());
  if (!maker.IsDone())
    return fail({.code = ErrorCode::ResultInvalid, .detail = "a patch has no border"});
  return maker.Face();
}

}  // namespace

Result<TopoDS_Shape> makeFaces(const FillResult& fill) {
  return guarded([&]() -> Result<TopoDS_Shape> {
    std::vector<TopoDS_Shape> faces;
    for (std::size_t i = 0; i < fill.patches.size(); ++i) {
      const auto made = makeFace(fill, i);
      if (!made) return fail(made.error());
      TopoDS_Shape face = *made;
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
