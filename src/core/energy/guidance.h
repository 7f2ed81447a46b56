// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "core/spline/bspline_surface.h"

namespace fairing::energy {

/// What guides a patch at one of its parameters: the integrand
///   lambda [(R_u . normal)^2 + (R_v . normal)^2] + gamma (R - point)^2      [WuYang2015] eq. 1
///   and 2.
struct GuidanceSample {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double lambda = 0.0;
  double gamma = 0.0;
};

/// A normal the user sets near a point: weighs lambda there and fades to nothing at `radius`.
struct NormalHandle {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;
  double weight = 1.0;
  double radius = 0.0;  ///< mm
};

/// The continuous form: N and S are splines over the unit square (the patch's own parameters mapped
/// to it), N not necessarily of unit length. Integrated exactly. [WuYang2015] section 2 and 3.
struct ContinuousGuidance {
  spline::BsplineSurface normals;
  spline::BsplineSurface reference;
};

/// The discrete form: unit normals, points and weights on an (n+1) x (m+1) grid of the unit square,
/// sums in place of integrals. [WuYang2015] section 4. Row i * (m + 1) + j belongs to the parameter
/// (i / n, j / m).
struct DiscreteGuidance {
  int n = 0, m = 0;
  spline::Poles normals, points;
  Eigen::VectorXd lambda, gamma;  ///< weights per sample, multiplied by the global ones
};

/// All guidance of one fill. Empty members do nothing.
struct Guidance {
  double lambda = 0.0;  ///< >= 0
  double gamma = 0.0;   ///< >= 0
  std::optional<ContinuousGuidance> continuous;
  std::optional<DiscreteGuidance> discrete;
  std::vector<NormalHandle> handles;
  /// Nearest point and unit normal on a reference shape (faces given with --reference), empty =
  /// none.
  std::function<GuidanceSample(const Eigen::Vector3d& near)> reference;

  [[nodiscard]] bool acts() const {
    return (lambda > 0.0 || gamma > 0.0) &&
           (continuous || discrete || !handles.empty() || reference);
  }
};

}  // namespace fairing::energy
