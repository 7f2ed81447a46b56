// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <vector>

#include "occt/edge_curve.h"
#include "occt/face_curve.h"

namespace fairing::occt {

/// The foot of a point of a curve on a face's surface, which may go on beyond the face.
struct ShadowPoint {
  Eigen::Vector2d w = Eigen::Vector2d::Zero();  ///< the surface's parameters
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double distance = 0.0;  ///< mm from the curve
  bool onFace = false;    ///< within the face or on its border, straight below the curve
};

/// A part of the shadow that lies on the face, in the curve's parameters.
struct ShadowRun {
  double from = 0.0, to = 1.0;
};

/// The shadow an edge throws on a face along the normals of its surface, over [0, 1] along the
/// edge's own curve. Sampled once; a query goes on from the nearest samples by Newton's method, so
/// that a closed surface has no seam for it. Not to be used by two threads at once.
class CurveShadow {
 public:
  static constexpr int kPlaces = 128;  ///< samples() are at the shares k / kPlaces

  CurveShadow(const TopoDS_Edge& edge, const TopoDS_Face& face);

  [[nodiscard]] const FaceDomain& face() const { return face_; }
  [[nodiscard]] const std::vector<ShadowPoint>& samples() const { return samples_; }
  [[nodiscard]] ShadowPoint at(double t) const;
  /// The part round a sample that is on the face, up to where it leaves it.
  [[nodiscard]] ShadowRun runRound(int sample) const;
  /// A run as an edge: the curve itself where it lies on the face.
  [[nodiscard]] TopoDS_Edge edgeOver(const ShadowRun& run) const;

 private:
  [[nodiscard]] ShadowPoint below(const Eigen::Vector3d& target, const SurfacePoint& start) const;
  [[nodiscard]] std::vector<SurfacePoint> grid(const TopoDS_Face& face) const;
  /// Between a share on the face and one that is not.
  [[nodiscard]] double exitBetween(double inside, double outside) const;

  TopoDS_Edge edge_;
  EdgeCurve curve_;
  FaceDomain face_;
  DomainBox domain_;
  std::vector<ShadowPoint> samples_;
};

}  // namespace fairing::occt
