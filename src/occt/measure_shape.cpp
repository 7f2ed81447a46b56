// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/measure_shape.h"

#include "occt/face_projector.h"
#include "occt/guarded.h"

namespace fairing::occt {

Result<analysis::FillReport> measureShape(const boundary::BoundaryLoop& loop,
                                          const TopoDS_Shape& patches,
                                          const Tolerance& tolerance) {
  return guarded([&]() -> Result<analysis::FillReport> {
    const FacesProjector faces(patches);
    if (faces.isEmpty()) return fail({.code = ErrorCode::ShapeEmpty});
    const auto footOf = [&](std::size_t, const analysis::ProbePoint& probe) {
      const FaceFoot found = faces.nearest(probe.point);
      analysis::MeasuredFoot foot{found.distance, found.normal, 0.0};
      const Eigen::Vector3d across = found.normal.cross(probe.tangent).normalized();
      if (found.at.isRegular()) {
        foot.curvature = across.dot(found.at.secondForm(found.normal) * across);
      }
      return foot;
    };
    return analysis::measureLoop(loop, analysis::probeLoop(loop), tolerance, footOf);
  });
}

}  // namespace fairing::occt
