// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/guidance_samples.h"

#include <algorithm>
#include <cmath>

#include "core/spline/quadrature.h"

namespace fairing::energy {
namespace {

using spline::KnotVector;

struct Domain {
  const KnotVector& u;
  const KnotVector& v;
  [[nodiscard]] double width() const { return u.last() - u.first(); }
  [[nodiscard]] double height() const { return v.last() - v.first(); }
};

template <class Visit>
void forEachGaussPoint(
    const KnotVector& u, int nu, const KnotVector& v, int nv, const Visit& visit) {
  const auto alongV = spline::gaussLegendre(nv, v);
  for (const auto& qu : spline::gaussLegendre(nu, u))
    for (const auto& qv : alongV) visit(qu, qv);
}

// Knots of the patch and of the guide together: between them every integrand is one polynomial.
KnotVector commonBreaks(const KnotVector& patch, const KnotVector& guide) {
  const auto scaled = guide.mapped(patch.first(), patch.last()).breaks();
  std::vector<double> all = patch.breaks();
  all.insert(all.end(), scaled.begin(), scaled.end());
  std::sort(all.begin(), all.end());
  const double same = 1e-12 * (patch.last() - patch.first());
  all.erase(std::unique(all.begin(), all.end(), [&](double a, double b) { return b - a < same; }),
            all.end());
  return KnotVector::fromBreaks(1, all);
}

void addContinuous(const Guidance& g, const Domain& d, std::vector<WeightedSample>& samples) {
  const auto& [normals, reference] = *g.continuous;
  const auto unit = [](double x, const KnotVector& k) {
    return (x - k.first()) / (k.last() - k.first());
  };
  const auto at = [&](const spline::BsplineSurface& s, double u, double v) {
    return s.evaluate(s.u.first() + u * (s.u.last() - s.u.first()),
                      s.v.first() + v * (s.v.last() - s.v.first()));
  };
  // Degree of B^2 N^2 or (R - S)^2, at most twice the sum; n Gauss points are exact to degree 2n
  // - 1.
  const auto points = [](int patch, int n, int s) {
    return std::max(patch + n, std::max(patch, s)) + 1;
  };
  const auto split = [](const KnotVector& patch, const KnotVector& n, const KnotVector& s) {
    return commonBreaks(commonBreaks(patch, n), s);
  };
  forEachGaussPoint(
      split(d.u, normals.u, reference.u),
      points(d.u.degree(), normals.u.degree(), reference.u.degree()),
      split(d.v, normals.v, reference.v),
      points(d.v.degree(), normals.v.degree(), reference.v.degree()),
      [&](const spline::QuadraturePoint& qu, const spline::QuadraturePoint& qv) {
        const double u = unit(qu.parameter, d.u), v = unit(qv.parameter, d.v);
        samples.push_back({qu.parameter,
                           qv.parameter,
                           qu.weight * qv.weight,
                           {at(normals, u, v), at(reference, u, v), g.lambda, g.gamma}});
      });
}

void addDiscrete(const Guidance& g, const Domain& d, std::vector<WeightedSample>& samples) {
  const DiscreteGuidance& grid = *g.discrete;
  const double share = d.width() * d.height() / ((grid.n + 1) * (grid.m + 1));
  for (int i = 0; i <= grid.n; ++i)
    for (int j = 0; j <= grid.m; ++j) {
      const Eigen::Index k = i * (grid.m + 1) + j;
      samples.push_back({d.u.first() + d.width() * i / grid.n,
                         d.v.first() + d.height() * j / grid.m,
                         share,
                         {grid.normals.row(k),
                          grid.points.row(k),
                          g.lambda * grid.lambda[k],
                          g.gamma * grid.gamma[k]}});
    }
}

// A handle fades with the distance r from its point as (1 - (r / radius)^2)^2: smooth, and nothing
// beyond the radius.
double handleWeight(const NormalHandle& handle, const Eigen::Vector3d& point) {
  const double x = (point - handle.point).squaredNorm() / (handle.radius * handle.radius);
  return x < 1.0 ? handle.weight * (1.0 - x) * (1.0 - x) : 0.0;
}

void addLookedUp(const Guidance& g,
                 const Domain& d,
                 const spline::BsplineSurface& current,
                 std::vector<WeightedSample>& samples) {
  forEachGaussPoint(
      d.u,
      d.u.degree(),
      d.v,
      d.v.degree(),
      [&](const spline::QuadraturePoint& qu, const spline::QuadraturePoint& qv) {
        const Eigen::Vector3d here = current.evaluate(qu.parameter, qv.parameter);
        const double weight = qu.weight * qv.weight;
        for (const NormalHandle& handle : g.handles)
          if (const double w = handleWeight(handle, here); w > 0.0)
            samples.push_back({qu.parameter,
                               qv.parameter,
                               weight,
                               {handle.normal.normalized(), here, g.lambda * w, 0.0}});
        if (!g.reference) return;
        GuidanceSample guide = g.reference(here);
        guide.lambda *= g.lambda;
        guide.gamma *= g.gamma;
        samples.push_back({qu.parameter, qv.parameter, weight, guide});
      });
}

}  // namespace

std::vector<WeightedSample> guidanceSamples(const Guidance& guidance,
                                            const KnotVector& u,
                                            const KnotVector& v,
                                            const spline::BsplineSurface& current) {
  const Domain domain{u, v};
  std::vector<WeightedSample> samples;
  if (guidance.continuous) addContinuous(guidance, domain, samples);
  if (guidance.discrete) addDiscrete(guidance, domain, samples);
  if (!guidance.handles.empty() || guidance.reference)
    addLookedUp(guidance, domain, current, samples);
  return samples;
}

}  // namespace fairing::energy
