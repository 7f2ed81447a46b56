// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/curvature.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

// With W^2 = EG - F^2 and the second form against R_u x R_v (fundamental_forms.h), that is times W:
// q = E n - 2 F m + G l,   H = q / (2 W^3),   K = (l n - m^2) / W^4.

namespace fairing::analysis {

using Eigen::Vector3d;

double Curvature::halfDifference() const {
  return std::sqrt(std::max(0.0, mean * mean - gauss));
}

double Curvature::largest() const {
  return std::abs(mean) + halfDifference();
}

Curvature curvatureOf(const spline::ThirdOrderJet& jet) {
  const auto [e, f, g, l, m, n] = spline::fundamentalForms(jet);
  const spline::FirstOrderJet en = e * n, fm = f * m, gl = g * l, eg = e * g, ff = f * f;
  const double w2 = eg.value - ff.value, w = std::sqrt(w2), w3 = w2 * w;
  const double q = en.value - 2.0 * fm.value + gl.value;
  Curvature c;
  c.areaElement = w;
  c.mean = q / (2.0 * w3);
  c.gauss = (l.value * n.value - m.value * m.value) / (w2 * w2);
  // dH = dq / (2 W^3) - 3 H dW^2 / (2 W^2)
  const double hu = (en.u - 2.0 * fm.u + gl.u) / (2.0 * w3) - 1.5 * c.mean * (eg.u - ff.u) / w2;
  const double hv = (en.v - 2.0 * fm.v + gl.v) / (2.0 * w3) - 1.5 * c.mean * (eg.v - ff.v) / w2;
  c.meanGradientSquared = (g.value * hu * hu - 2.0 * f.value * hu * hv + e.value * hv * hv) / w2;
  return c;
}

Curvature curvatureAt(const spline::BsplineSurface& surface, double u, double v) {
  return curvatureOf(spline::thirdOrderJet(surface.derivatives(u, v, 3)));
}

double normalCurvature(const spline::SurfaceJet& jet, const Vector3d& direction) {
  Eigen::Matrix2d metric;
  metric << jet.u.dot(jet.u), jet.u.dot(jet.v), jet.u.dot(jet.v), jet.v.dot(jet.v);
  const Eigen::Vector2d d =
      metric.inverse() * Eigen::Vector2d(jet.u.dot(direction), jet.v.dot(direction));
  const Vector3d normal = jet.normalVector().normalized();
  const double second = d[0] * d[0] * normal.dot(jet.uu) + 2.0 * d[0] * d[1] * normal.dot(jet.uv) +
                        d[1] * d[1] * normal.dot(jet.vv);
  return second / d.dot(metric * d);
}

}  // namespace fairing::analysis
