// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/curvature.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/spline/quadrature.h"

// Notation: E, F, G first form; l, m, n second form times W with W^2 = EG - F^2 (normal m = R_u x
// R_v not of unit length); q = E n - 2 F m + G l, so that  H = q / (2 W^3),  K = (l n - m^2) / W^4.

namespace fairing::analysis {
namespace {

using Eigen::Vector3d;

struct Jet3 {
  explicit Jet3(const spline::Partials& all) : all_(all) {}
  [[nodiscard]] Vector3d operator()(int a, int b) const { return all_.col(4 * a + b); }

 private:
  const spline::Partials& all_;
};

// Value of a quantity and its derivatives along u and v.
struct Jet1 {
  double value, u, v;
};

Jet1 product(const Jet1& a, const Jet1& b) {
  return {a.value * b.value, a.u * b.value + a.value * b.u, a.v * b.value + a.value * b.v};
}

// R_(a,b) . R_(c,d) with its derivatives.
Jet1 dot(const Jet3& r, int a, int b, int c, int d) {
  return {r(a, b).dot(r(c, d)),
          r(a + 1, b).dot(r(c, d)) + r(a, b).dot(r(c + 1, d)),
          r(a, b + 1).dot(r(c, d)) + r(a, b).dot(r(c, d + 1))};
}

// (R_u x R_v) . R_(a,b) with its derivatives.
Jet1 height(const Jet3& r, int a, int b) {
  const Vector3d m = r(1, 0).cross(r(0, 1));
  const Vector3d mu = r(2, 0).cross(r(0, 1)) + r(1, 0).cross(r(1, 1));
  const Vector3d mv = r(1, 1).cross(r(0, 1)) + r(1, 0).cross(r(0, 2));
  return {
      m.dot(r(a, b)), mu.dot(r(a, b)) + m.dot(r(a + 1, b)), mv.dot(r(a, b)) + m.dot(r(a, b + 1))};
}

Curvature curvatureFrom(const spline::Partials& partials) {
  const Jet3 r(partials);
  const Jet1 e = dot(r, 1, 0, 1, 0), f = dot(r, 1, 0, 0, 1), g = dot(r, 0, 1, 0, 1);
  const Jet1 l = height(r, 2, 0), m = height(r, 1, 1), n = height(r, 0, 2);
  const Jet1 en = product(e, n), fm = product(f, m), gl = product(g, l);
  const Jet1 eg = product(e, g), ff = product(f, f);
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

// A quadrature point of one direction with its basis functions, evaluated once for the whole grid.
struct GridPoint {
  double weight;
  spline::BasisRow basis;
};

std::vector<GridPoint> gridLine(const spline::KnotVector& knots, int points) {
  std::vector<GridPoint> line;
  for (const auto& q : spline::gaussLegendre(points, knots))
    line.push_back({q.weight, spline::basisRow(knots, q.parameter, 3)});
  return line;
}

}  // namespace

double Curvature::largest() const {
  return std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
}

Curvature curvatureAt(const spline::BsplineSurface& surface, double s, double t) {
  return curvatureFrom(surface.derivatives(s, t, 3));
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
  constexpr int kPoints = 3;  // a span: integrands are rational, figures good to about 1e-3
  for (const spline::BsplineSurface& patch : patches) {
    const auto alongU = gridLine(patch.u, kPoints), alongV = gridLine(patch.v, kPoints);
    for (const GridPoint& qu : alongU)
      for (const GridPoint& qv : alongV) {
        const Curvature c = curvatureFrom(patch.derivatives(qu.basis, qv.basis, 3));
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
