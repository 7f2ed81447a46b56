// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <TopoDS_Face.hxx>
#include <memory>
#include <vector>

#include "occt/surface_point.h"

namespace fairing::occt {

class FaceProjector;

/// Where a point is nearest to a face.
struct FaceFoot {
  double distance = 0.0;  ///< mm
  const FaceProjector* face = nullptr;
  SurfacePoint at;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, the face's orientation respected
  /// The point lies beside the faces: neither above nor below them, nor out where they meet.
  bool beside = false;
};

/// Nearest points of a face: of its surface within its trim, whose border is surface o pcurve. The
/// face's own 3D edges and tolerances play no part. Samples are taken once; a query refines the
/// nearest ones by Newton's method. Not to be used by two threads at once.
class FaceProjector {
 public:
  explicit FaceProjector(const TopoDS_Face& face);

  [[nodiscard]] FaceFoot nearest(const Eigen::Vector3d& target) const;
  /// Whether the face reaches as far as `step` (mm, tangent to it) from a foot on it.
  [[nodiscard]] bool contains(const FaceFoot& foot, const Eigen::Vector3d& step) const;

 private:
  struct BorderSample {
    double parameter;
    Eigen::Vector3d point;
  };
  struct Border {
    Geom2dAdaptor_Curve pcurve;
    double first = 0.0, last = 1.0;
    std::vector<BorderSample> samples;
  };
  struct InnerSample {
    double u, v;
    Eigen::Vector3d point;
  };
  void sampleBorders(const TopoDS_Face& forward);
  void sampleInside();
  [[nodiscard]] SurfacePoint onBorder(const Border& border, double parameter) const;
  [[nodiscard]] SurfacePoint footOnBorder(const Border& border,
                                          const Eigen::Vector3d& target) const;
  [[nodiscard]] bool isInside(const SurfacePoint& foot) const;
  [[nodiscard]] Eigen::Vector3d normalAt(const SurfacePoint& foot) const;

  BRepAdaptor_Surface surface_;
  DomainBox domain_;
  double normalSign_ = 1.0;
  std::unique_ptr<BRepTopAdaptor_FClass2d> trim_;
  std::vector<Border> borders_;
  std::vector<InnerSample> inside_;
};

/// Of several faces the nearest one.
class FacesProjector {
 public:
  explicit FacesProjector(const TopoDS_Shape& faces);

  [[nodiscard]] bool isEmpty() const { return projectors_.empty(); }
  [[nodiscard]] FaceFoot nearest(const Eigen::Vector3d& target) const;

 private:
  std::vector<FaceProjector> projectors_;
  double size_ = 0.0;  // diagonal of the faces' box
};

}  // namespace fairing::occt
