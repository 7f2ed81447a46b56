// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/reference.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <memory>
#include <mutex>
#include <vector>

#include "occt/face_projector.h"
#include "occt/guarded.h"
#include "occt/mesh_reference.h"

namespace fairing::occt {
namespace {

using Reference = std::function<energy::GuidanceSample(const Eigen::Vector3d&)>;

Handle(Poly_Triangulation)
    moved(const Handle(Poly_Triangulation) & mesh, const TopLoc_Location& location) {
  if (location.IsIdentity()) return mesh;
  const Handle(Poly_Triangulation) copy = mesh->Copy();
  for (int k = 1; k <= copy->NbNodes(); ++k)
    copy->SetNode(k, copy->Node(k).Transformed(location.Transformation()));
  return copy;
}

struct Parts {
  TopoDS_Compound faces;  // those that have a surface
  std::vector<Handle(Poly_Triangulation)> meshes;
};

Parts partsOf(const TopoDS_Shape& shape) {
  Parts parts;
  const BRep_Builder builder;
  builder.MakeCompound(parts.faces);
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    TopLoc_Location location;
    if (!BRep_Tool::Surface(face).IsNull())
      builder.Add(parts.faces, face);
    else if (const auto mesh = BRep_Tool::Triangulation(face, location); !mesh.IsNull())
      parts.meshes.push_back(moved(mesh, location));
  }
  return parts;
}

/// Of two the one that covers the point, else the nearer one.
energy::GuidanceSample nearer(const Eigen::Vector3d& point,
                              const energy::GuidanceSample& a,
                              const energy::GuidanceSample& b) {
  if ((a.lambda > 0.0) != (b.lambda > 0.0)) return a.lambda > 0.0 ? a : b;
  return (a.point - point).squaredNorm() <= (b.point - point).squaredNorm() ? a : b;
}

/// Projectors must not be shared by threads: each question takes an idle one, or a new one.
class ProjectorPool {
 public:
  explicit ProjectorPool(const TopoDS_Shape& faces) : faces_(faces) {}

  FaceFoot nearest(const Eigen::Vector3d& point) {
    auto projector = take();
    const FaceFoot foot = projector->nearest(point);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(projector));
    return foot;
  }

 private:
  std::unique_ptr<FacesProjector> take() {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        auto projector = std::move(idle_.back());
        idle_.pop_back();
        return projector;
      }
    }
    return std::make_unique<FacesProjector>(faces_);
  }

  TopoDS_Shape faces_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<FacesProjector>> idle_;
};

Reference referenceOnFaces(const std::shared_ptr<ProjectorPool>& pool) {
  return [pool](const Eigen::Vector3d& near) -> energy::GuidanceSample {
    try {
      const FaceFoot foot = pool->nearest(near);
      const double weight = foot.beside ? 0.0 : 1.0;
      return {.normal = foot.normal, .point = foot.at.point, .lambda = weight, .gamma = weight};
    } catch (const Standard_Failure&) {
      return {};  // weights 0: nothing is known here
    }
  };
}

}  // namespace

Result<Reference> referenceOn(const TopoDS_Shape& shape) {
  return guarded([&]() -> Result<Reference> {
    const Parts parts = partsOf(shape);
    std::vector<Reference> all;
    for (const Handle(Poly_Triangulation) & mesh : parts.meshes)
      all.push_back(referenceOnMesh(mesh));
    if (TopExp_Explorer(parts.faces, TopAbs_FACE).More())
      all.push_back(referenceOnFaces(std::make_shared<ProjectorPool>(parts.faces)));
    if (all.empty()) return fail({.code = ErrorCode::ShapeEmpty});
    if (all.size() == 1) return all.front();
    return [all](const Eigen::Vector3d& near) {
      energy::GuidanceSample best = all.front()(near);
      for (std::size_t k = 1; k < all.size(); ++k) best = nearer(near, best, all[k](near));
      return best;
    };
  });
}

}  // namespace fairing::occt
