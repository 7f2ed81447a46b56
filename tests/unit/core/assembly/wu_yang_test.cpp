// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The linear systems of [WuYang2015] written out as printed, index formula by index formula,
// against the gradients that our assembly gives. n x m are the degrees of a Bezier patch over the
// unit square, d(i) = B_{i-1}^{n-1} - B_i^{n-1} and dd(i) = B_{i-2}^{n-2} - 2 B_{i-1}^{n-2} +
// B_i^{n-2}. Corrected are: Proposition 1, W holds B_l^m where B_l^{m-1} is printed; section 4, C^
// holds B_k^{n-1} where B_k^n is printed; there lambda belongs to each sample. Our discrete form
// weighs every sample by its share of the area where the paper has plain sums.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "core/assembly/assemble_energy.h"
#include "core/assembly/assemble_guidance.h"
#include "core/spline/quadrature.h"
#include "support/matchers.h"
#include "support/quadratic_forms.h"
#include "support/random_splines.h"

namespace fairing::assembly {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of quadratic forms
using Eigen::Matrix3d;
using Eigen::Vector3d;
using spline::BsplineSurface;
using spline::KnotVector;

constexpr int kN = 5, kM = 4;
constexpr double kLambda = 3.0, kGamma = 2.0;

double bernstein(int i, int degree, double t) {
  if (i < 0 || i > degree) return 0.0;
  double binomial = 1.0;
  for (int k = 0; k < i; ++k) binomial = binomial * (degree - k) / (k + 1);
  return binomial * std::pow(t, i) * std::pow(1.0 - t, degree - i);
}

double d(int i, int degree, double t) {
  return bernstein(i - 1, degree - 1, t) - bernstein(i, degree - 1, t);
}

double dd(int i, int degree, double t) {
  return bernstein(i - 2, degree - 2, t) - 2.0 * bernstein(i - 1, degree - 2, t) +
         bernstein(i, degree - 2, t);
}

// A sum over samples in place of the integral over the unit square: Gauss points with their
// weights, or a grid.
struct Sample {
  double u, v, weight;
  Vector3d normal;
  double lambda, gamma;
};
using Samples = std::vector<Sample>;

Matrix3d sum(const Samples& samples, const std::function<Matrix3d(const Sample&)>& integrand) {
  Matrix3d result = Matrix3d::Zero();
  for (const Sample& s : samples) result += s.weight * integrand(s);
  return result;
}

Matrix3d lambdaNN(const Sample& s) {
  return s.lambda * s.normal * s.normal.transpose();
}

using Coefficient = std::function<Matrix3d(int k, int l)>;

// F from C, G from D: differences of the coefficients of Delta^10 P and Delta^01 P. Outside
// 0..n-1 (or 0..m-1) C and D count as zero, which is the three cases of the paper in one.
Matrix3d alongU(const Coefficient& c, int k, int l) {
  Matrix3d f = Matrix3d::Zero();
  if (k > 0) f += c(k - 1, l);
  if (k < kN) f -= c(k, l);
  return f;
}
Matrix3d alongV(const Coefficient& c, int k, int l) {
  Matrix3d g = Matrix3d::Zero();
  if (l > 0) g += c(k, l - 1);
  if (l < kM) g -= c(k, l);
  return g;
}

struct Setting {
  KnotVector u = KnotVector::bezier(kN), v = KnotVector::bezier(kM);
  BsplineSurface patch, normals, reference;
  energy::Guidance guidance;

  Setting() {
    Random random{5};
    patch = randomSurface(random, u, v);
    reference = randomSurface(random, u, v);
    normals = randomSurface(random, KnotVector::bezier(2), KnotVector::bezier(3), 1.0);
    guidance.lambda = kLambda;
    guidance.gamma = kGamma;
  }

  [[nodiscard]] Samples gauss() const {
    Samples samples;
    for (const auto& qu : spline::gaussLegendre(10, 0.0, 1.0))
      for (const auto& qv : spline::gaussLegendre(10, 0.0, 1.0))
        samples.push_back({qu.parameter,
                           qv.parameter,
                           qu.weight * qv.weight,
                           normals.evaluate(qu.parameter, qv.parameter),
                           kLambda,
                           kGamma});
    return samples;
  }

  // d(energy)/d(P_ij) from our matrices.
  [[nodiscard]] spline::Poles ourGradient(const energy::EnergyTerms& terms) const {
    const auto layout = freePatch(u, v);
    const auto guided = assembleGuidance(layout, guidance, {patch});
    spline::Poles gradient = assembleEnergy(layout, terms) * patch.poles;
    gradient += unflattened(guided.coupled() * flattened(patch.poles) - guided.load);
    return gradient;
  }
};

Matrix3d weightW(const Samples& samples, int i, int j, int k, int l) {
  return sum(samples, [&](const Sample& s) {
    return Matrix3d(s.gamma * bernstein(i, kN, s.u) * bernstein(j, kM, s.v) *
                    bernstein(k, kN, s.u) * bernstein(l, kM, s.v) * Matrix3d::Identity());
  });
}

// C^ij and D^ij of Proposition 1 with `tensor` in the place of I + lambda N N'.
Coefficient coefficientC(const Samples& samples,
                         int i,
                         int j,
                         const std::function<Matrix3d(const Sample&)>& tensor) {
  return [=, &samples](int k, int l) {
    return Matrix3d(kN * kN * sum(samples, [&](const Sample& s) {
                      return Matrix3d(d(i, kN, s.u) * bernstein(j, kM, s.v) *
                                      bernstein(k, kN - 1, s.u) * bernstein(l, kM, s.v) *
                                      tensor(s));
                    }));
  };
}

Coefficient coefficientD(const Samples& samples,
                         int i,
                         int j,
                         const std::function<Matrix3d(const Sample&)>& tensor) {
  return [=, &samples](int k, int l) {
    return Matrix3d(kM * kM * sum(samples, [&](const Sample& s) {
                      return Matrix3d(bernstein(i, kN, s.u) * d(j, kM, s.v) *
                                      bernstein(k, kN, s.u) * bernstein(l, kM - 1, s.v) *
                                      tensor(s));
                    }));
  };
}

// sum_kl M_kl P_kl
Vector3d applied(const Coefficient& matrix, const BsplineSurface& poles) {
  Vector3d result = Vector3d::Zero();
  for (int k = 0; k <= kN; ++k)
    for (int l = 0; l <= kM; ++l) result += matrix(k, l) * poles.pole(k, l);
  return result;
}

Vector3d positionTerm(const Setting& g, const Samples& samples, int i, int j) {
  const Coefficient w = [&](int k, int l) { return weightW(samples, i, j, k, l); };
  return applied(w, g.patch) - applied(w, g.reference);
}

// Sums of a few hundred products of numbers up to about 100.
constexpr double kRounding = 1e-10;

TEST(WuYang, Proposition1IsTheGradientOfTheMembrane) {
  Setting g;
  g.guidance.continuous = {g.normals, g.reference};
  const spline::Poles ours = g.ourGradient(energy::membrane());
  const Samples samples = g.gauss();
  const auto tensor = [](const Sample& s) { return Matrix3d(Matrix3d::Identity() + lambdaNN(s)); };
  for (int i = 1; i < kN; ++i)
    for (int j = 1; j < kM; ++j) {
      const Coefficient c = coefficientC(samples, i, j, tensor);
      const Coefficient e = coefficientD(samples, i, j, tensor);
      const Coefficient both = [&](int k, int l) {
        return Matrix3d(alongU(c, k, l) + alongV(e, k, l));
      };
      const Vector3d theirs = applied(both, g.patch) + positionTerm(g, samples, i, j);
      EXPECT_THAT(Vector3d(ours.row(g.patch.index(i, j))), IsNear(theirs, kRounding));
    }
}

TEST(WuYang, Equation4IsTheGradientOfTheThinPlate) {
  Setting g;
  g.guidance.continuous = {g.normals, g.reference};
  const spline::Poles ours = g.ourGradient(energy::thinPlate());
  const Samples samples = g.gauss();
  const double n = kN, m = kM;
  const auto scalar = [&](const std::function<double(const Sample&)>& f) {
    return sum(samples, [&](const Sample& s) { return Matrix3d(f(s) * Matrix3d::Identity()); });
  };
  for (int i = 2; i <= kN - 2; ++i)
    for (int j = 2; j <= kM - 2; ++j) {
      Vector3d theirs = positionTerm(g, samples, i, j);
      const auto p = [&](int k, int l) { return g.patch.pole(k, l); };
      for (int k = 0; k <= kN - 2; ++k)  // H Delta^20 P
        for (int l = 0; l <= kM; ++l)
          theirs += n * n * (n - 1) * (n - 1) * scalar([&](const Sample& s) {
                      return dd(i, kN, s.u) * bernstein(j, kM, s.v) * bernstein(k, kN - 2, s.u) *
                             bernstein(l, kM, s.v);
                    }) *
                    (p(k + 2, l) - 2.0 * p(k + 1, l) + p(k, l));
      for (int k = 0; k < kN; ++k)  // I Delta^11 P
        for (int l = 0; l < kM; ++l)
          theirs += 2.0 * n * n * m * m * scalar([&](const Sample& s) {
                      return d(i, kN, s.u) * d(j, kM, s.v) * bernstein(k, kN - 1, s.u) *
                             bernstein(l, kM - 1, s.v);
                    }) *
                    (p(k + 1, l + 1) - p(k + 1, l) - p(k, l + 1) + p(k, l));
      for (int k = 0; k <= kN; ++k)  // J Delta^02 P
        for (int l = 0; l <= kM - 2; ++l)
          theirs += m * m * (m - 1) * (m - 1) * scalar([&](const Sample& s) {
                      return bernstein(i, kN, s.u) * dd(j, kM, s.v) * bernstein(k, kN, s.u) *
                             bernstein(l, kM - 2, s.v);
                    }) *
                    (p(k, l + 2) - 2.0 * p(k, l + 1) + p(k, l));
      const Coefficient lc = coefficientC(samples, i, j, lambdaNN);
      const Coefficient mc = coefficientD(samples, i, j, lambdaNN);
      theirs += applied([&](int k, int l) { return Matrix3d(alongU(lc, k, l) + alongV(mc, k, l)); },
                        g.patch);
      EXPECT_THAT(Vector3d(ours.row(g.patch.index(i, j))), IsNear(theirs, 10.0 * kRounding));
    }
}

TEST(WuYang, Section4IsTheGradientUnderDiscreteNormals) {
  Setting g;
  Random random{6};
  energy::DiscreteGuidance grid;
  grid.n = 6;
  grid.m = 5;
  const Eigen::Index count = (grid.n + 1) * (grid.m + 1);
  grid.normals = randomMatrix(random, count, 3).rowwise().normalized();
  grid.lambda = randomMatrix(random, count, 1).cwiseAbs();
  grid.gamma = randomMatrix(random, count, 1).cwiseAbs();
  grid.points.resize(count, 3);
  Samples samples;
  for (int i = 0; i <= grid.n; ++i)
    for (int j = 0; j <= grid.m; ++j) {
      const int k = i * (grid.m + 1) + j;
      const double u = static_cast<double>(i) / grid.n, v = static_cast<double>(j) / grid.m;
      grid.points.row(k) = g.reference.evaluate(u, v).transpose();
      samples.push_back({u,
                         v,
                         1.0 / static_cast<double>(count),
                         grid.normals.row(k),
                         kLambda * grid.lambda[k],
                         kGamma * grid.gamma[k]});
    }
  g.guidance.discrete = grid;
  const spline::Poles ours = g.ourGradient({});  // the guided part alone
  for (int i = 1; i < kN; ++i)
    for (int j = 1; j < kM; ++j) {
      const Coefficient c = coefficientC(samples, i, j, lambdaNN);
      const Coefficient e = coefficientD(samples, i, j, lambdaNN);
      const Coefficient both = [&](int k, int l) {
        return Matrix3d(alongU(c, k, l) + alongV(e, k, l));
      };
      const Vector3d theirs = applied(both, g.patch) + positionTerm(g, samples, i, j);
      EXPECT_THAT(Vector3d(ours.row(g.patch.index(i, j))), IsNear(theirs, kRounding));
    }
}

}  // namespace
}  // namespace fairing::assembly
