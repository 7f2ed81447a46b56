// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/reference.h"

#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "occt/face_projector.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

/// A projector for every thread that asks: they must not be shared.
class ProjectorPool {
 public:
  explicit ProjectorPool(const TopoDS_Shape& faces) : faces_(faces) {}

  const FacesProjector& mine() {
    const std::lock_guard lock(mutex_);
    auto& own = projectors_[std::this_thread::get_id()];
    if (!own) own = std::make_unique<FacesProjector>(faces_);
    return *own;
  }

 private:
  TopoDS_Shape faces_;
  std::mutex mutex_;
  std::map<std::thread::id, std::unique_ptr<FacesProjector>> projectors_;
};

}  // namespace

using Reference = std::function<energy::GuidanceSample(const Eigen::Vector3d&)>;

Result<Reference> referenceOn(const TopoDS_Shape& faces) {
  return guarded([&]() -> Result<Reference> {
    const auto pool = std::make_shared<ProjectorPool>(faces);
    if (pool->mine().isEmpty()) return fail({.code = ErrorCode::ShapeEmpty});
    return [pool](const Eigen::Vector3d& near) -> energy::GuidanceSample {
      try {
        const FaceFoot foot = pool->mine().nearest(near);
        const double weight = foot.beside ? 0.0 : 1.0;
        return {.normal = foot.normal, .point = foot.at.point, .lambda = weight, .gamma = weight};
      } catch (const Standard_Failure&) {
        return {};  // weights 0: nothing is known here
      }
    };
  });
}

}  // namespace fairing::occt
