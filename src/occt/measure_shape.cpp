// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/measure_shape.h"

#include "core/analysis/side_samples.h"
#include "occt/face_projector.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

using analysis::MeasuredFoot;
using Eigen::Vector3d;

MeasuredFoot measureAt(const boundary::BoundarySide& side,
                       const analysis::SidePlace& place,
                       const FacesProjector& faces) {
  const boundary::CurveSample curve = side.ribbon.curve(place.t);
  const FaceFoot found = faces.nearest(curve.point);
  MeasuredFoot foot;
  foot.t = place.t;
  foot.inCorner = place.inCorner;
  foot.point = curve.point;
  foot.gap = found.distance;
  foot.normal = found.normal;
  const Vector3d across = found.normal.cross(curve.derivative).normalized();
  if (found.at.isRegular()) foot.curvature = across.dot(found.at.secondForm(found.normal) * across);
  return foot;
}

}  // namespace

Result<analysis::FillReport> measureShape(const boundary::BoundaryLoop& loop,
                                          const TopoDS_Shape& patches,
                                          const Tolerance& tolerance) {
  return guarded([&]() -> Result<analysis::FillReport> {
    const FacesProjector faces(patches);
    if (faces.isEmpty()) return fail({.code = ErrorCode::ShapeEmpty});
    std::vector<std::vector<MeasuredFoot>> feet;
    int balance = 0;
    for (const boundary::BoundarySide& side : loop.sides) {
      auto& own = feet.emplace_back();
      for (const analysis::SidePlace& place : analysis::sidePlaces(side.ribbon)) {
        own.push_back(measureAt(side, place, faces));
        if (!side.ribbon.hasSupport()) continue;
        balance += side.ribbon.support(place.t).normal.dot(own.back().normal) >= 0.0 ? 1 : -1;
      }
    }
    analysis::FillReport report = analysis::emptyReport(loop, tolerance);
    report.reversed = balance < 0;
    for (std::size_t k = 0; k < loop.sides.size(); ++k) {
      for (const MeasuredFoot& foot : feet[k]) {
        analysis::addFoot(
            loop.sides[k], foot, loop.diagonal, balance < 0 ? -1.0 : 1.0, report.sides[k]);
      }
      analysis::finishSide(report.sides[k]);
    }
    analysis::judge(report);
    return report;
  });
}

}  // namespace fairing::occt
