// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/spline/bspline_surface.h"
#include "core/spline/fundamental_forms.h"

namespace fairing::analysis {

/// Curvature at a point of a patch, against its normal u x v. Lengths in mm.
struct Curvature {
  double mean = 0.0;                 ///< H, 1/mm
  double gauss = 0.0;                ///< K, 1/mm^2
  double areaElement = 0.0;          ///< |R_u x R_v|
  double meanGradientSquared = 0.0;  ///< |grad H|^2 on the surface, 1/mm^4
  /// k1^2 + k2^2 = 4 H^2 - 2 K.
  [[nodiscard]] double total() const { return 4.0 * mean * mean - 2.0 * gauss; }
  /// The principal curvatures k1 >= k2, H +- sqrt(H^2 - K). 1/mm.
  [[nodiscard]] double k1() const { return mean + halfDifference(); }
  [[nodiscard]] double k2() const { return mean - halfDifference(); }
  /// max(|k1|, |k2|).
  [[nodiscard]] double largest() const;

 private:
  [[nodiscard]] double halfDifference() const;
};

/// Not finite where R_u x R_v vanishes.
[[nodiscard]] Curvature curvatureOf(const spline::ThirdOrderJet& jet);

[[nodiscard]] Curvature curvatureAt(const spline::BsplineSurface& surface, double u, double v);

/// Normal curvature in a direction (not necessarily of unit length or tangent): II(d, d) / I(d, d)
/// against u x v.
[[nodiscard]] double normalCurvature(const spline::SurfaceJet& jet,
                                     const Eigen::Vector3d& direction);

}  // namespace fairing::analysis
