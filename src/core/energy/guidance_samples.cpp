// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/guidance_samples.h"

#include <algorithm>

#include "core/base/parallel_for.h"
#include "core/energy/lay_field.h"
#include "core/spline/quadrature.h"

namespace fairing::energy {
namespace {

using spline::KnotVector;

GuidanceSample weighted(GuidanceSample guide, const Guidance& by) {
  guide.lambda *= by.lambda;
  guide.gamma *= by.gamma;
  return guide;
}

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
                           {normals.evaluate(u, v), reference.evaluate(u, v), g.lambda, gamma},
                           GuideKind::Field});
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
                          g.gamma * grid.gamma[k]},
                         GuideKind::Field});
    }
}

void addLookedUp(const Guidance& g,
                 const NormalFeet& feet,
                 const Domain& d,
                 const spline::BsplineSurface& current,
                 std::vector<WeightedSample>& samples) {
  std::vector<WeightedSample> places;
  forEachGaussPoint(d.u,
                    d.u.degree(),
                    d.v,
                    d.v.degree(),
                    [&](const spline::QuadraturePoint& qu, const spline::QuadraturePoint& qv) {
                      places.push_back({qu.parameter, qv.parameter, qu.weight * qv.weight, {}, {}});
                    });
  const auto addAll = [&](GuideKind kind, const auto& guideAt) {
    const std::size_t first = samples.size();
    samples.insert(samples.end(), places.begin(), places.end());
    // Nearest points are dear to look up.
    inParallel(places.size(), [&](std::size_t k) {
      WeightedSample& s = samples[first + k];
      s.kind = kind;
      s.guide = weighted(guideAt(current.evaluate(s.u, s.v)), g);
    });
  };
  if (g.hasNormals()) addAll(GuideKind::Normals, [&](const auto& here) { return feet.at(here); });
  if (g.reference) addAll(GuideKind::Reference, g.reference);
}

// One point more than for the energy: (R - S)^2 is integrated exactly where R and S share their
// knots.
void addParametric(const Guidance& g, const Domain& d, std::vector<WeightedSample>& samples) {
  forEachGaussPoint(d.u,
                    d.u.degree() + 1,
                    d.v,
                    d.v.degree() + 1,
                    [&](const spline::QuadraturePoint& qu, const spline::QuadraturePoint& qv) {
                      const GuidanceSample guide =
                          g.parametric((qu.parameter - d.u.first()) / d.width(),
                                       (qv.parameter - d.v.first()) / d.height());
                      samples.push_back({qu.parameter,
                                         qv.parameter,
                                         qu.weight * qv.weight,
                                         weighted(guide, g),
                                         GuideKind::Parametric});
                    });
}

}  // namespace

std::vector<WeightedSample> guidanceSamples(const Guidance& guidance,
                                            const NormalFeet& feet,
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
  if (guidance.hasNormals() || guidance.reference)
    addLookedUp(guidance, feet, domain, current, samples);
  return samples;
}

}  // namespace fairing::energy
