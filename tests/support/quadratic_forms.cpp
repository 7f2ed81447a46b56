// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/quadratic_forms.h"

#include <cmath>
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

double guidedIntegrand(const spline::SurfaceJet& r,
                       const Eigen::Vector3d& n,
                       const Eigen::Vector3d& s,
                       double lambda,
                       double gamma) {
  const double tilt = std::pow(r.u.dot(n), 2) + std::pow(r.v.dot(n), 2);
  return lambda * tilt + gamma * (r.point - s).squaredNorm();
}

energy::Guidance discreteGuidance(Random& random, double lambda, double gamma) {
  energy::DiscreteGuidance grid;
  grid.n = 4;
  grid.m = 3;
  const Eigen::Index count = (grid.n + 1) * (grid.m + 1);
  grid.points = randomMatrix(random, count, 3);
  grid.normals = randomMatrix(random, count, 3).rowwise().normalized();
  grid.lambda = randomMatrix(random, count, 1).cwiseAbs();
  grid.gamma = randomMatrix(random, count, 1).cwiseAbs();
  energy::Guidance guidance;
  guidance.lambda = lambda;
  guidance.gamma = gamma;
  guidance.discrete = grid;
  return guidance;
}

double discreteEnergy(const spline::BsplineSurface& patch, const energy::Guidance& guidance) {
  const energy::DiscreteGuidance& grid = *guidance.discrete;
  double sum = 0.0;
  for (int i = 0; i <= grid.n; ++i)
    for (int j = 0; j <= grid.m; ++j) {
      const Eigen::Index k = i * (grid.m + 1) + j;
      const auto jet = patch.jet(patch.u.last() * i / grid.n, patch.v.last() * j / grid.m);
      sum += guidedIntegrand(jet,
                             grid.normals.row(k),
                             grid.points.row(k),
                             guidance.lambda * grid.lambda[k],
                             guidance.gamma * grid.gamma[k]);
    }
  return 0.5 * sum * patch.u.last() * patch.v.last() / ((grid.n + 1) * (grid.m + 1));
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
