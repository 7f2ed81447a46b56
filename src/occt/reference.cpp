// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/reference.h"

#include <memory>

#include "occt/face_projector.h"
#include "occt/guarded.h"

namespace fairing::occt {

using Reference = std::function<energy::GuidanceSample(const Eigen::Vector3d&)>;

Result<Reference> referenceOn(const TopoDS_Shape& faces) {
  return guarded([&]() -> Result<Reference> {
    const auto projector = std::make_shared<FacesProjector>(faces);
    if (projector->isEmpty()) return fail({.code = ErrorCode::ShapeEmpty});
    return [projector](const Eigen::Vector3d& near) -> energy::GuidanceSample {
      try {
        const FaceFoot foot = projector->nearest(near);
        return {.normal = foot.normal, .point = foot.at.point, .lambda = 1.0, .gamma = 1.0};
      } catch (const Standard_Failure&) {
        return {};  // weights 0: nothing is known here
      }
    };
  });
}

}  // namespace fairing::occt
