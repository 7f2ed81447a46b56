// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <vector>

#include "core/energy/guidance.h"
#include "core/spline/nearest_patch.h"

namespace fairing::energy {

/// A handle or a curve that guides nothing.
struct IdleGuide {
  Eigen::Vector3d point;  ///< the handle, or where the curve starts
  bool isCurve = false;
  int number = 0;         ///< among the handles, or among the curves, from 1
  double distance = 0.0;  ///< mm to the nearest place it could guide
};

/// Where the handles and curves of a guide lie on some patches: at the nearest points, from which
/// their radii count. So a handle may float above a patch, and one guide's normals fade into
/// another's. Those without weight are as if they were not there.
class NormalFeet {
 public:
  NormalFeet(const Guidance& guidance, const std::vector<spline::BsplineSurface>& patches);

  /// What they say together at a point of the patches: the mean of the normals that reach it,
  /// weighted, N and -N being the same. Lambda grows with every guide that reaches the point, up to
  /// the mean of their weights, so that many that agree weigh as one. Weight 0 where none does, or
  /// where they cancel each other.
  [[nodiscard]] GuidanceSample at(const Eigen::Vector3d& point) const;
  /// The first of them that lies a radius or more beside the patches, or whose radius reaches none
  /// of the given points.
  [[nodiscard]] std::optional<IdleGuide> idle(const std::vector<Eigen::Vector3d>& points) const;

 private:
  struct Source {
    std::vector<Eigen::Vector3d> feet, normals;  // in order; one of each for a handle
    double weight, radius;
    IdleGuide self;  // its distance is that beside the patches
  };
  void add(const spline::NearestPatch& nearest,
           const std::vector<Eigen::Vector3d>& points,
           const std::vector<Eigen::Vector3d>& normals,
           Source source);

  std::vector<Source> sources_;
};

}  // namespace fairing::energy
