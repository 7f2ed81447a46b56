// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/error.h"
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

/// A normal the user sets: weighs lambda at the nearest point of the surface and fades to nothing
/// at `radius` from there.
struct NormalHandle {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;
  double weight = 1.0;
  double radius = 0.0;  ///< mm
};

/// Normals along a curve: between its points both change linearly; fades to nothing at `radius`
/// from it.
struct NormalCurve {
  std::vector<Eigen::Vector3d> points, normals;  ///< as many, in order
  double weight = 1.0;
  double radius = 0.0;  ///< mm
};

/// The continuous form: N and S are splines over the unit square (the patch's own parameters mapped
/// to it), N not necessarily of unit length. Integrated exactly. [WuYang2015] section 2 and 3.
struct ContinuousGuidance {
  spline::BsplineSurface normals;
  std::optional<spline::BsplineSurface> reference = {};  ///< empty = no S
};

/// The discrete form: unit normals, points and weights on an (n+1) x (m+1) grid of the unit square,
/// sums in place of integrals. [WuYang2015] section 4. Row i * (m + 1) + j belongs to the parameter
/// (i / n, j / m).
struct DiscreteGuidance {
  int n = 0, m = 0;
  spline::Poles normals, points;
  Eigen::VectorXd lambda, gamma;  ///< weights per sample, multiplied by the global ones
};

/// Where a field's parameters (0, 0), (1, 0) and (0, 1) lie in space: the corners of the patch that
/// are nearest to them say how the field lies on the patch. Without them it lies as the patch's own
/// parameters do.
struct FieldCorners {
  Eigen::Vector3d origin, alongU, alongV;
};

/// All guidance of one fill. Empty members do nothing.
struct Guidance {
  double lambda = 0.0;  ///< >= 0
  double gamma = 0.0;   ///< >= 0
  std::optional<ContinuousGuidance> continuous;
  std::optional<DiscreteGuidance> discrete;
  std::optional<FieldCorners> corners;  ///< of `continuous` and `discrete`
  std::vector<NormalHandle> handles;
  std::vector<NormalCurve> curves;
  /// Nearest point and unit normal on a reference shape (faces given with --reference), empty =
  /// none.
  std::function<GuidanceSample(const Eigen::Vector3d& near)> reference;
  /// The guide at the patch's own parameters mapped to the unit square, empty = none. Integrated by
  /// Gauss-Legendre.
  std::function<GuidanceSample(double u, double v)> parametric;

  [[nodiscard]] bool hasField() const { return continuous || discrete; }
  /// Whether a handle or a curve has any weight.
  [[nodiscard]] bool hasNormals() const {
    const auto weighs = [](const auto& normals) { return normals.weight > 0.0; };
    return std::any_of(handles.begin(), handles.end(), weighs) ||
           std::any_of(curves.begin(), curves.end(), weighs);
  }
  /// Whether what is found near a surface changes as the surface comes closer to it, so that it is
  /// worth another look. Where a reference gives normals alone nothing holds points to it: looked
  /// up again and again, the surface would slide along it.
  [[nodiscard]] bool isDrawn() const { return hasNormals() || (reference && gamma > 0.0); }
  /// Whether there is anything to follow, whatever its weight.
  [[nodiscard]] bool isGiven() const {
    return hasField() || hasNormals() || reference || parametric;
  }
  [[nodiscard]] bool acts() const { return (lambda > 0.0 || gamma > 0.0) && isGiven(); }
};

/// How often guidance that isDrawn() is looked up again at most, and the move of the surface, as a
/// share of the diagonal, below which it is not.
inline constexpr int kLookUps = 5;
inline constexpr double kStill = 1e-4;

/// The same guidance with global weights of 1.
[[nodiscard]] Guidance weighingOne(Guidance guidance);

/// The first thing wrong with what guides: WeightNegative, NormalZero, FieldSize, NotFinite.
[[nodiscard]] std::optional<Error> validate(const Guidance& guidance);

}  // namespace fairing::energy
