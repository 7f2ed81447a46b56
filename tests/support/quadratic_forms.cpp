// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/quadratic_forms.h"

#include <numeric>

#include "core/spline/quadrature.h"

namespace fairing::testing {

layout::PatchLayout freePatch(const spline::KnotVector& u, const spline::KnotVector& v) {
  layout::PatchLayout layout;
  layout.pointCount = u.poleCount() * v.poleCount();
  layout::LayoutPatch patch;
  patch.u = u;
  patch.v = v;
  patch.points.resize(static_cast<std::size_t>(layout.pointCount));
  std::iota(patch.points.begin(), patch.points.end(), 0);
  layout.patches.push_back(std::move(patch));
  return layout;
}

double quadraticForm(const solver::Sparse& stiffness, const spline::Poles& poles) {
  return 0.5 * (poles.transpose() * (stiffness * poles)).trace();
}

double integral(const spline::BsplineSurface& surface,
                int points,
                const std::function<double(double, double)>& integrand) {
  double sum = 0.0;
  for (const auto& qu : spline::gaussLegendre(points, surface.u))
    for (const auto& qv : spline::gaussLegendre(points, surface.v))
      sum += qu.weight * qv.weight * integrand(qu.parameter, qv.parameter);
  return sum;
}

double membraneEnergy(const spline::BsplineSurface& surface) {
  return 0.5 * integral(surface, 12, [&](double u, double v) {
           const spline::SurfaceJet r = surface.jet(u, v);
           return r.u.squaredNorm() + r.v.squaredNorm();
         });
}

double thinPlateEnergy(const spline::BsplineSurface& surface) {
  return 0.5 * integral(surface, 12, [&](double u, double v) {
           const spline::SurfaceJet r = surface.jet(u, v);
           return r.uu.squaredNorm() + 2.0 * r.uv.squaredNorm() + r.vv.squaredNorm();
         });
}

Eigen::VectorXd flattened(const spline::Poles& poles) {
  return Eigen::Map<const Eigen::VectorXd>(poles.data(), poles.size());
}

spline::Poles unflattened(const Eigen::VectorXd& flat) {
  return Eigen::Map<const spline::Poles>(flat.data(), flat.size() / 3, 3);
}

solver::QuadraticProgram holdingBorder(const spline::BsplineSurface& patch,
                                       const solver::Sparse& stiffness,
                                       int rows) {
  const int nu = patch.u.poleCount(), nv = patch.v.poleCount();
  solver::QuadraticProgram program;
  program.stiffness = stiffness;
  program.values = patch.poles;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j)
      program.fixed.push_back(i < rows || j < rows || i >= nu - rows || j >= nv - rows ? 1 : 0);
  return program;
}

}  // namespace fairing::testing
