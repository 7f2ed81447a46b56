// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/curvature_picture.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/base/angle.h"
#include "occt/from_occt.h"
#include "occt/guarded.h"
#include "occt/triangles_of.h"

namespace fairing::occt {
namespace {

using analysis::ParameterMesh;
using analysis::PictureSurface;
using analysis::PlacedJet;

// Along an edge of a triangle: stripes of a reflection are smooth to the eye.
constexpr double kTurn = 4.0;  // degrees
// The kernel's triangles against the diagonal, and their turn: what they have to follow is the
// border.
constexpr double kSag = 2e-4, kBorderTurn = 5.0;

PlacedJet jetAt(const BRepAdaptor_Surface& surface, double u, double v) {
  gp_Pnt point;
  gp_Vec du, dv, duu, dvv, duv, duuu, dvvv, duuv, duvv;
  PlacedJet placed;
  try {
    surface.D3(u, v, point, du, dv, duu, dvv, duv, duuu, dvvv, duuv, duvv);
  } catch (const Standard_Failure&) {  // an offset of a surface of too low an order
    surface.D0(u, v, point);
    placed.point = fromOcct(point);
    placed.jet.setConstant(std::numeric_limits<double>::quiet_NaN());
    return placed;
  }
  placed.point = fromOcct(point);
  placed.jet << fromOcct(du), fromOcct(dv), fromOcct(duu), fromOcct(duv), fromOcct(dvv),
      fromOcct(duuu), fromOcct(duuv), fromOcct(duvv), fromOcct(dvvv);
  return placed;
}

PictureSurface surfaceOf(const TopoDS_Face& face, int number) {
  const auto surface = std::make_shared<const BRepAdaptor_Surface>(face, false);
  return {[surface](double u, double v) { return jetAt(*surface, u, v); },
          face.Orientation() == TopAbs_REVERSED,
          number};
}

ParameterMesh meshOf(const TopoDS_Face& face, double diagonal) {
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(face, false);  // the face keeps no triangles
  BRepMesh_IncrementalMesh(copy, kSag * diagonal, false, kBorderTurn / kDegrees);
  TopLoc_Location location;
  const auto triangles = BRep_Tool::Triangulation(TopoDS::Face(copy), location);
  ParameterMesh mesh;
  if (triangles.IsNull() || !triangles->HasUVNodes()) return mesh;
  for (int node = 1; node <= triangles->NbNodes(); ++node)
    mesh.at.emplace_back(triangles->UVNode(node).X(), triangles->UVNode(node).Y());
  mesh.triangles = trianglesOf(*triangles);  // counter-clockwise about u x v
  return mesh;
}

double diagonalOf(const ShapeIndex& index, const std::vector<int>& faces) {
  Bnd_Box box;
  for (const int number : faces) BRepBndLib::AddOptimal(index.face(number), box, false, false);
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

}  // namespace

Result<analysis::CurvaturePicture> curvaturePicture(const ShapeIndex& index,
                                                    const std::vector<int>& faces,
                                                    int divisions) {
  return guarded([&]() -> Result<analysis::CurvaturePicture> {
    std::vector<int> drawn;
    for (const int number : faces)
      if (!index.hasFace(number))
        return fail({.code = ErrorCode::FaceOutOfRange,
                     .face = number,
                     .value = static_cast<double>(index.faceCount())});
    for (int number = 1; number <= index.faceCount(); ++number) {
      const bool isWanted =
          faces.empty() || std::find(faces.begin(), faces.end(), number) != faces.end();
      if (isWanted && !BRep_Tool::Surface(index.face(number)).IsNull()) drawn.push_back(number);
    }
    const double diagonal = diagonalOf(index, drawn);
    const analysis::PictureFineness fineness{diagonal / divisions, kTurn};
    analysis::CurvaturePicture picture;
    for (const int number : drawn) {
      const TopoDS_Face& face = index.face(number);
      picture.add(surfaceOf(face, number), meshOf(face, diagonal), fineness);
    }
    return picture;
  });
}

}  // namespace fairing::occt
