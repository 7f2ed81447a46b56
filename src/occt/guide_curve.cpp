// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/guide_curve.h"

#include <BRepAdaptor_CompCurve.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <GCPnts_UniformAbscissa.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>

#include "occt/face_projector.h"
#include "occt/from_occt.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 65;
constexpr double kAlong = 1e-3;  // sine of the angle between a direction and the curve

Result<TopoDS_Wire> wireOf(const TopoDS_Shape& edges) {
  TopTools_ListOfShape list;
  for (TopExp_Explorer it(edges, TopAbs_EDGE); it.More(); it.Next()) list.Append(it.Current());
  BRepBuilderAPI_MakeWire wire;
  wire.Add(list);
  if (!wire.IsDone()) return fail({.code = ErrorCode::GuideCurveBroken});
  return wire.Wire();
}

}  // namespace

Result<GuideCurve> guideCurve(const TopoDS_Shape& edges,
                              const TopoDS_Shape& faces,
                              const std::optional<Vector3d>& direction) {
  if (faces.IsNull() && !direction) return fail({.code = ErrorCode::GuideCurveBare});
  return guarded([&]() -> Result<GuideCurve> {
    const auto wire = wireOf(edges);
    if (!wire) return fail(wire.error());
    const BRepAdaptor_CompCurve curve(*wire);
    const GCPnts_UniformAbscissa places(curve, kSamples);
    if (!places.IsDone()) return fail({.code = ErrorCode::GuideCurveBroken});
    std::optional<FacesProjector> projector;
    if (!faces.IsNull()) projector.emplace(faces);
    GuideCurve guide;
    for (int k = 1; k <= places.NbPoints(); ++k) {
      gp_Pnt point;
      gp_Vec tangent;
      curve.D1(places.Parameter(k), point, tangent);
      const Vector3d along = fromOcct(tangent).normalized();
      Vector3d normal = projector ? projector->nearest(fromOcct(point)).normal
                                  : Vector3d(*direction - direction->dot(along) * along);
      if (!(normal.norm() > (projector ? 0.0 : kAlong * direction->norm())))
        return fail({.code = ErrorCode::GuideCurveAlong, .where = fromOcct(point)});
      guide.points.push_back(fromOcct(point));
      guide.normals.push_back(normal.normalized());
    }
    return guide;
  });
}

}  // namespace fairing::occt
