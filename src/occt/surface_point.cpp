// SPDX-License-Identifier: LGPL-2.1-or-later
// Notation: S(u, v) the surface, n a unit normal,
//   I  = (Su.Su  Su.Sv; Su.Sv  Sv.Sv)   first fundamental form, J = (Su Sv), 3 x 2
//   II = (Suu.n  Suv.n; Suv.n  Svv.n)   second fundamental form
// As a form in space: J I^-1 II I^-1 J', so that tangent vectors may be put in as they are.
#include "occt/surface_point.h"

#include <Eigen/LU>
#include <algorithm>

#include "occt/from_occt.h"

namespace fairing::occt {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Below this sine between Su and Sv a normal has lost half its digits.
constexpr double kSingularSine = 1e-7;
/// One partial derivative this much shorter than the other is a pole of the surface.
constexpr double kSingularRatio = 1e-7;
constexpr int kNewtonSteps = 20;
constexpr int kHalvings = 10;

Matrix2d firstForm(const SurfacePoint& s) {
  Matrix2d first;
  first << s.su.dot(s.su), s.su.dot(s.sv), s.su.dot(s.sv), s.sv.dot(s.sv);
  return first;
}

/// The step of Newton's method for 1/2 |S - target|^2, or of Gauss and Newton where that is not
/// convex.
Vector2d newtonStep(const SurfacePoint& s, const Vector3d& residual) {
  const Matrix2d first = firstForm(s);
  Matrix2d second;
  second << residual.dot(s.suu), residual.dot(s.suv), residual.dot(s.suv), residual.dot(s.svv);
  Matrix2d hessian = first + second;
  if (!(hessian(0, 0) > 0.0 && hessian.determinant() > 0.1 * first.determinant())) hessian = first;
  if (!(hessian.determinant() > 0.0)) return Vector2d::Zero();
  return -hessian.inverse() * Vector2d(residual.dot(s.su), residual.dot(s.sv));
}

}  // namespace

bool SurfacePoint::isRegular() const {
  const double a = su.norm();
  const double b = sv.norm();
  return std::min(a, b) > kSingularRatio * std::max(a, b) && cross().norm() > kSingularSine * a * b;
}

Eigen::Matrix3d SurfacePoint::secondForm(const Vector3d& normal) const {
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << su, sv;
  Matrix2d second;
  second << suu.dot(normal), suv.dot(normal), suv.dot(normal), svv.dot(normal);
  const Eigen::Matrix<double, 3, 2> dual = tangents * firstForm(*this).inverse();
  return dual * second * dual.transpose();
}

Vector2d SurfacePoint::parametersOf(const Vector3d& step) const {
  return firstForm(*this).inverse() * Vector2d(su.dot(step), sv.dot(step));
}

SurfacePoint evaluate(const BRepAdaptor_Surface& surface, double u, double v) {
  gp_Pnt p;
  gp_Vec su, sv, suu, svv, suv;
  surface.D2(u, v, p, su, sv, suu, svv, suv);
  return {
      u, v, fromOcct(p), fromOcct(su), fromOcct(sv), fromOcct(suu), fromOcct(suv), fromOcct(svv)};
}

SurfacePoint footFrom(const BRepAdaptor_Surface& surface,
                      const Vector3d& target,
                      SurfacePoint start,
                      const DomainBox& domain) {
  SurfacePoint best = start;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Vector3d residual = best.point - target;
    Vector2d step = newtonStep(best, residual);
    // Against the border of the domain only the other parameter moves, by its own best step.
    const Vector2d at(best.u, best.v);
    for (int k = 0; k < 2; ++k) {
      const double wanted = at[k] + step[k];
      if (wanted >= domain.min()[k] && wanted <= domain.max()[k]) continue;
      step[k] = std::clamp(wanted, domain.min()[k], domain.max()[k]) - at[k];
      const Vector3d& along = k == 0 ? best.sv : best.su;
      const Vector3d& fixed = k == 0 ? best.su : best.sv;
      step[1 - k] = -(residual + step[k] * fixed).dot(along) / along.squaredNorm();
      step[1 - k] =
          std::clamp(at[1 - k] + step[1 - k], domain.min()[1 - k], domain.max()[1 - k]) - at[1 - k];
      break;
    }
    bool nearer = false;
    for (int h = 0; h < kHalvings && !nearer; ++h, step *= 0.5) {
      const Vector2d to = at + step;
      const SurfacePoint next = evaluate(surface, to.x(), to.y());
      nearer = (next.point - target).norm() < residual.norm();
      if (nearer) best = next;
    }
    const double gain = residual.norm() - (best.point - target).norm();
    if (!nearer || gain <= 1e-15 * (1.0 + residual.norm())) break;
  }
  return best;
}

}  // namespace fairing::occt
