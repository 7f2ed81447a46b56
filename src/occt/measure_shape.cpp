// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/measure_shape.h"

#include "occt/face_projector.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

/// How far from the border (over the loop's diagonal) it is looked on which side of it the face
/// lies.
constexpr double kStepInside = 1e-4;

/// Whether the face goes on against `direction` and not along it.
bool endsAcross(const FaceFoot& foot, const Eigen::Vector3d& direction, double step) {
  return !foot.face->contains(foot, step * direction) &&
         foot.face->contains(foot, -step * direction);
}

}  // namespace

Result<analysis::FillReport> measureShape(const boundary::BoundaryLoop& loop,
                                          const TopoDS_Shape& patches,
                                          const Tolerance& tolerance) {
  return guarded([&]() -> Result<analysis::FillReport> {
    const FacesProjector faces(patches);
    if (faces.isEmpty()) return fail({.code = ErrorCode::ShapeEmpty});
    const auto footOf = [&](std::size_t, const analysis::ProbePoint& probe) {
      const FaceFoot found = faces.nearest(probe.point);
      analysis::MeasuredFoot foot{found.distance, found.normal};
      const Eigen::Vector3d across = found.normal.cross(probe.tangent).normalized();
      if (endsAcross(found, across, kStepInside * loop.diagonal)) foot.side = -1.0;
      if (found.at.isRegular()) {
        foot.curvature = across.dot(found.at.secondForm(found.normal) * across);
      }
      return foot;
    };
    return analysis::measureLoop(loop, analysis::probeLoop(loop), tolerance, footOf);
  });
}

}  // namespace fairing::occt
