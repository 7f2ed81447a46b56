// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/closest_point.h"

#include <Eigen/LU>
#include <algorithm>

namespace fairing::spline {
namespace {

constexpr int kMostSteps = 12;
// Of the domain. What is left after a Newton step is of the order of its square, far below any gap
// that is reported.
constexpr double kSmallStep = 1e-6;

// Newton's step for the squared distance; Gauss-Newton's where the Hessian is not positive
// definite.
Eigen::Vector2d step(const SurfaceJet& jet, const Eigen::Vector3d& offset) {
  const Eigen::Vector2d gradient(jet.u.dot(offset), jet.v.dot(offset));
  Eigen::Matrix2d metric;
  metric << jet.u.dot(jet.u), jet.u.dot(jet.v), jet.u.dot(jet.v), jet.v.dot(jet.v);
  Eigen::Matrix2d hessian = metric;
  hessian(0, 0) += jet.uu.dot(offset);
  hessian(1, 1) += jet.vv.dot(offset);
  hessian(0, 1) += jet.uv.dot(offset);
  hessian(1, 0) = hessian(0, 1);
  const bool positive = hessian(0, 0) > 0.0 && hessian.determinant() > 1e-12 * metric.determinant();
  const Eigen::Matrix2d& used = positive ? hessian : metric;
  if (used.determinant() <= 0.0) return Eigen::Vector2d::Zero();
  return -used.inverse() * gradient;
}

}  // namespace

SurfaceFoot closestPoint(const BsplineSurface& surface,
                         const Eigen::Vector3d& point,
                         double u,
                         double v) {
  const double width = surface.u.last() - surface.u.first(),
               height = surface.v.last() - surface.v.first();
  SurfaceFoot best{u, v, 0.0, surface.jet(u, v)};
  best.distance = (best.jet.point - point).norm();
  for (int k = 0; k < kMostSteps; ++k) {
    Eigen::Vector2d move = step(best.jet, best.jet.point - point);
    const bool isLast =
        std::abs(move[0]) < kSmallStep * width && std::abs(move[1]) < kSmallStep * height;
    SurfaceFoot next = best;
    for (int halving = 0; halving < 6; ++halving, move *= 0.5) {
      next.u = std::clamp(best.u + move[0], surface.u.first(), surface.u.last());
      next.v = std::clamp(best.v + move[1], surface.v.first(), surface.v.last());
      if (next.u == best.u && next.v == best.v) return best;
      next.jet = surface.jet(next.u, next.v);
      next.distance = (next.jet.point - point).norm();
      if (next.distance <= best.distance) break;
    }
    if (next.distance > best.distance) return best;
    best = next;
    if (isLast) return best;
  }
  return best;
}

}  // namespace fairing::spline
