// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/guidance_samples.h"

#include <algorithm>
#include <cmath>

#include "core/energy/lay_field.h"
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

spline::BsplineSurface overUnitSquare(const spline::BsplineSurface& s) {
  return {s.u.mapped(0.0, 1.0), s.v.mapped(0.0, 1.0), s.poles};
}

void addContinuous(const Guidance& g, const Domain& d, std::vector<WeightedSample>& samples) {
  const spline::BsplineSurface normals = overUnitSquare(g.continuous->normals);
  // Without S its place is taken by N, at no weight.
  const double gamma = g.continuous->reference ? g.gamma : 0.0;
  const spline::BsplineSurface reference =
      overUnitSquare(g.continuous->reference.value_or(g.continuous->normals));
  const auto unit = [](double x, const KnotVector& k) {
    return (x - k.first()) / (k.last() - k.first());
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
                           {normals.evaluate(u, v), reference.evaluate(u, v), g.lambda, gamma}});
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

// One point more than for the energy: (R - S)^2 is integrated exactly where R and S share their
// knots.
void addParametric(const Guidance& g, const Domain& d, std::vector<WeightedSample>& samples) {
  forEachGaussPoint(d.u,
                    d.u.degree() + 1,
                    d.v,
                    d.v.degree() + 1,
                    [&](const spline::QuadraturePoint& qu, const spline::QuadraturePoint& qv) {
                      GuidanceSample guide =
                          g.parametric((qu.parameter - d.u.first()) / d.width(),
                                       (qv.parameter - d.v.first()) / d.height());
                      guide.lambda *= g.lambda;
                      guide.gamma *= g.gamma;
                      samples.push_back({qu.parameter, qv.parameter, qu.weight * qv.weight, guide});
                    });
}

}  // namespace

std::vector<WeightedSample> guidanceSamples(const Guidance& guidance,
                                            const KnotVector& u,
                                            const KnotVector& v,
                                            const spline::BsplineSurface& current) {
  const Domain domain{u, v};
  std::vector<WeightedSample> samples;
  if (guidance.hasField()) {
    const Guidance laid = laidOn(guidance, current);
    if (laid.continuous) addContinuous(laid, domain, samples);
    if (laid.discrete) addDiscrete(laid, domain, samples);
  }
  if (guidance.parametric) addParametric(guidance, domain, samples);
  if (!guidance.handles.empty() || guidance.reference)
    addLookedUp(guidance, domain, current, samples);
  return samples;
}

}  // namespace fairing::energy
