// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/curvature.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/spline/fundamental_forms.h"
#include "core/spline/surface_grid.h"

// With W^2 = EG - F^2 and the second form against R_u x R_v (fundamental_forms.h), that is times W:
// q = E n - 2 F m + G l,   H = q / (2 W^3),   K = (l n - m^2) / W^4.

namespace fairing::analysis {
namespace {

using Eigen::Vector3d;

Curvature curvatureFrom(const spline::ThirdOrderJet& jet) {
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

// Integrands are rational: four points a span give figures good to about 1e-3, wherever there are
// spans enough.
constexpr int kLeastOnSpan = 4;
constexpr int kLeastOnPatch = 16;

spline::GridLine gridLine(const spline::KnotVector& knots) {
  const int spans = static_cast<int>(knots.breaks().size()) - 1;
  return {knots, std::max(kLeastOnSpan, (kLeastOnPatch + spans - 1) / spans)};
}

}  // namespace

double Curvature::largest() const {
  return std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
}

Curvature curvatureAt(const spline::BsplineSurface& surface, double u, double v) {
  return curvatureFrom(spline::thirdOrderJet(surface.derivatives(u, v, 3)));
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

FairnessReport measureFairness(const std::vector<spline::BsplineSurface>& patches) {
  FairnessReport report;
  for (const spline::BsplineSurface& patch : patches) {
    const spline::GridLine alongU = gridLine(patch.u), alongV = gridLine(patch.v);
    const auto jets = spline::gridJets(patch, alongU, alongV);
    auto jet = jets.begin();
    for (const spline::GridPoint& qu : alongU.points)
      for (const spline::GridPoint& qv : alongV.points) {
        const Curvature c = curvatureFrom(*jet++);
        const double area = qu.weight * qv.weight * c.areaElement;
        if (!std::isfinite(c.mean)) continue;  // a collapsed point has no curvature
        report.area += area;
        report.totalCurvature += area * c.total();
        report.meanCurvatureGradient += area * c.meanGradientSquared;
        report.largestCurvature = std::max(report.largestCurvature, c.largest());
      }
  }
  return report;
}

}  // namespace fairing::analysis
