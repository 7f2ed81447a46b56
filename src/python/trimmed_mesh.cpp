// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/trimmed_mesh.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

#include "occt/make_faces.h"
#include "python/error_to_python.h"

namespace fairing::python {
namespace {

/// A grid cell of a surface that turns by a radian over the hole is as far from it.
constexpr double kSagitta = 1.0 / 8.0;

void append(std::vector<float>& list, const Eigen::Vector3d& vector) {
  for (const double coordinate : vector) list.push_back(static_cast<float>(coordinate));
}

void addFace(Mesh& mesh,
             const Poly_Triangulation& triangles,
             const spline::BsplineSurface& patch,
             bool reversed) {
  const auto first = static_cast<std::int32_t>(mesh.points.size() / 3) - 1;  // nodes count from 1
  for (int node = 1; node <= triangles.NbNodes(); ++node) {
    const gp_Pnt2d at = triangles.UVNode(node);
    const spline::SurfaceJet jet = patch.jet(at.X(), at.Y());
    append(mesh.points, jet.point);
    append(mesh.normals, (reversed ? -1.0 : 1.0) * jet.normalVector().normalized());
  }
  for (int i = 1; i <= triangles.NbTriangles(); ++i) {
    int a, b, c;  // counter-clockwise about u x v
    triangles.Triangle(i).Get(a, b, c);
    if (reversed) std::swap(b, c);
    mesh.triangles.insert(mesh.triangles.end(), {first + a, first + b, first + c});
  }
}

}  // namespace

Mesh trimmedMeshOf(const FillResult& fill, int divisions) {
  return trimmedMeshOf(
      valueOf(occt::makeFaces(fill)), fill.patches, fill.reversed, fill.report.diagonal, divisions);
}

Mesh trimmedMeshOf(const TopoDS_Shape& shape,
                   const std::vector<spline::BsplineSurface>& surfaces,
                   const std::vector<bool>& reversed,
                   double diagonal,
                   int divisions) {
  const double share = 1.0 / divisions;
  BRepMesh_IncrementalMesh(shape, kSagitta * share * share * diagonal, false, 2.0 * share);
  Mesh mesh;
  std::size_t patch = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next(), ++patch) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangles =
        BRep_Tool::Triangulation(TopoDS::Face(it.Current()), location);
    if (triangles.IsNull())
      throw Failure({.code = ErrorCode::ResultInvalid, .detail = "the face has no triangles"});
    addFace(mesh, *triangles, surfaces[patch], reversed[patch]);
  }
  return mesh;
}

}  // namespace fairing::python
