// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "core/spline/bspline_curve.h"
#include "core/spline/fit_curve.h"

namespace fairing::boundary {

/// Position and derivative of a boundary curve at a parameter t in [0, 1].
using CurveSample = spline::CurvePoint;

/// The support face at the foot of a boundary point.
struct SupportSample {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< on the support face, a rounding or a CAD
                                                      ///< tolerance off the curve
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, the face's orientation respected; a
                                                      ///< limit at singular points
  /// Shape operator -dn as a symmetric form in space: II(a, b) = a' * secondForm * b for tangent
  /// vectors a and b, 1/mm.
  Eigen::Matrix3d secondForm = Eigen::Matrix3d::Zero();
  /// Unit, tangent to the face: along those of its iso-curves that cross the edge; zero where the
  /// face has none to speak of.
  Eigen::Vector3d iso = Eigen::Vector3d::Zero();
  bool singular = false;  ///< no normal here, nor a limit
  bool isLimit = false;   ///< the face has no normal here: it is the limit from within the face
};

/// A parameter where a curve is less smooth than elsewhere.
struct CurveBreak {
  double t = 0.0;
  int continuity = 1;  ///< number of continuous derivatives
};

/// What one edge of the hole hands over to the patches: a curve and, where a face lies beside it,
/// that face's normals along the curve. t runs over [0, 1] in the direction of the loop.
struct Ribbon {
  std::function<CurveSample(double t)> curve;
  /// The curve itself where it is a polynomial B-spline (clamped, domain [0, 1], at least C1):
  /// taken over exactly.
  std::optional<spline::BsplineCurve> polynomial;
  /// Inner breaks of a curve that is not polynomial (the knots of a rational one), ascending.
  std::vector<CurveBreak> breaks;
  /// Empty where the edge has no face beside it.
  std::function<SupportSample(double t)> support;

  [[nodiscard]] bool hasSupport() const { return static_cast<bool>(support); }
};

/// The ribbon run through the other way, its normals as they were.
[[nodiscard]] Ribbon reversed(const Ribbon& ribbon);

}  // namespace fairing::boundary
