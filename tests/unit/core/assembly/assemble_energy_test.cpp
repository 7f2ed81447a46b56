// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/assemble_energy.h"

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>

#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/quadratic_forms.h"
#include "support/random_splines.h"

namespace fairing::assembly {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of quadratic forms
using Eigen::MatrixXd;
using Eigen::Vector3d;
using energy::membrane;
using energy::thinPlate;
using energy::triharmonic;
using spline::BsplineSurface;
using spline::KnotVector;

struct Knots {
  KnotVector u, v;
};

// Uneven spans, different degrees, a repeated knot, a domain that is not square.
Knots someKnots(unsigned seed = 0) {
  Random random{seed};
  const KnotVector u = randomKnots(random, 4, 3, 2), v = randomKnots(random, 3, 2);
  return {u.mapped(0.0, 1.5), v.mapped(0.0, 2.0 / 3.0)};
}

MatrixXd denseEnergy(const Knots& knots, const energy::EnergyTerms& terms) {
  return MatrixXd(assembleEnergy(freePatch(knots.u, knots.v), terms));
}

int kernelDimension(const MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  // The smallest true eigenvalue of these patches is above 1e-7 of the largest, rounding below
  // 1e-13.
  return static_cast<int>(
      (solver.eigenvalues().array() < 1e-10 * solver.eigenvalues().maxCoeff()).count());
}

// What a function's poles give when the energy's matrix is applied to it.
double imageOf(const Knots& knots, const MatrixXd& matrix, const PointFunction& function) {
  const BsplineSurface surface = interpolated(function, knots.u, knots.v);
  return (matrix * surface.poles).norm() / matrix.norm();
}

TEST(AssembleEnergy, IsSymmetric) {
  for (const auto& terms : {membrane(), thinPlate(), triharmonic()}) {
    const MatrixXd h = denseEnergy(someKnots(), terms);
    EXPECT_LT((h - h.transpose()).norm(), 1e-14 * h.norm());
  }
}

TEST(AssembleEnergy, IsPositiveSemidefinite) {
  for (const auto& terms : {membrane(), thinPlate()}) {
    const MatrixXd h = denseEnergy(someKnots(), terms);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(h);
    EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-13 * solver.eigenvalues().maxCoeff());
  }
}

TEST(AssembleEnergy, MembraneVanishesOnConstantsAlone) {
  const Knots knots = someKnots();
  const MatrixXd h = denseEnergy(knots, membrane());
  EXPECT_EQ(kernelDimension(h), 1);
  EXPECT_LT(imageOf(knots, h, [](double, double) { return Vector3d(1.0, 2.0, 3.0); }), 1e-14);
}

TEST(AssembleEnergy, ThinPlateVanishesOnAffineMapsAlone) {
  const Knots knots = someKnots();
  const MatrixXd h = denseEnergy(knots, thinPlate());
  EXPECT_EQ(kernelDimension(h), 3);
  EXPECT_LT(imageOf(knots, h, [](double u, double v) { return Vector3d(1.0, u, v); }), 1e-14);
}

TEST(AssembleEnergy, MembraneOfAKnownPolynomial) {
  // (u, v, uv) over the unit square: 1/2 integral of 1 + v^2 + 1 + u^2 = 4/3.
  const KnotVector k = KnotVector::bezier(2);
  const auto surface = interpolated([](double u, double v) { return Vector3d(u, v, u * v); }, k, k);
  EXPECT_NEAR(
      quadraticForm(assembleEnergy(freePatch(k, k), membrane()), surface.poles), 4.0 / 3.0, 1e-14);
}

TEST(AssembleEnergy, ThinPlateOfAKnownPolynomial) {
  // (u, v, u^2 + 3uv - v^2) over the unit square: 1/2 (4 + 2 * 9 + 4) = 13.
  const KnotVector k = KnotVector::bezier(2);
  const auto surface = interpolated(
      [](double u, double v) { return Vector3d(u, v, u * u + 3.0 * u * v - v * v); }, k, k);
  EXPECT_NEAR(
      quadraticForm(assembleEnergy(freePatch(k, k), thinPlate()), surface.poles), 13.0, 1e-12);
}

TEST(AssembleEnergy, TriharmonicOfAKnownPolynomial) {
  // z = u^3 + 2 u v^2 + v^3 has the laplacian 10 u + 6 v: 1/2 (100 + 36) = 68.
  const KnotVector k = KnotVector::bezier(3);
  const auto surface = interpolated(
      [](double u, double v) { return Vector3d(u, v, u * u * u + 2.0 * u * v * v + v * v * v); },
      k,
      k);
  EXPECT_NEAR(
      quadraticForm(assembleEnergy(freePatch(k, k), triharmonic()), surface.poles), 68.0, 1e-11);
}

TEST(AssembleEnergy, TriharmonicVanishesWhereTheLaplacianIsConstant) {
  const KnotVector k = KnotVector::fromBreaks(4, {0.0, 0.4, 1.0});
  const auto surface = interpolated(
      [](double u, double v) {
        return Vector3d(u * u * u - 3.0 * u * v * v, u * u, u * v - 2.0 * v * v);
      },
      k,
      k);
  const auto stiffness = assembleEnergy(freePatch(k, k), triharmonic());
  EXPECT_LT((stiffness * surface.poles).norm(), 1e-11 * MatrixXd(stiffness).norm());
}

TEST(AssembleEnergy, IsTheIntegratedEnergyOfAnySurface) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    Random random{seed};
    const Knots knots = someKnots(seed);
    const BsplineSurface surface = randomSurface(random, knots.u, knots.v);
    const auto layout = freePatch(knots.u, knots.v);
    const double soft = membraneEnergy(surface), stiff = thinPlateEnergy(surface);
    EXPECT_NEAR(
        quadraticForm(assembleEnergy(layout, membrane()), surface.poles), soft, 1e-12 * soft);
    EXPECT_NEAR(
        quadraticForm(assembleEnergy(layout, thinPlate()), surface.poles), stiff, 1e-12 * stiff);
  }
}

TEST(AssembleEnergy, GradientIsThatOfTheIntegratedEnergy) {
  Random random{1};
  const Knots knots = someKnots();
  const BsplineSurface surface = randomSurface(random, knots.u, knots.v);
  const auto energyAt = [&](const auto& energy) {
    return [&](const Eigen::VectorXd& x) {
      return energy(BsplineSurface{knots.u, knots.v, unflattened(x)});
    };
  };
  const auto layout = freePatch(knots.u, knots.v);
  const auto check = [&](const auto& terms, const auto& energy) {
    const spline::Poles gradient = assembleEnergy(layout, terms) * surface.poles;
    const Eigen::VectorXd expected = quadraticGradient(energyAt(energy), flattened(surface.poles));
    EXPECT_THAT(flattened(gradient), IsNear(expected, 1e-11 * expected.norm()));
  };
  check(membrane(), membraneEnergy);
  check(thinPlate(), thinPlateEnergy);
}

TEST(AssembleEnergy, AMixedTermIsSymmetrised) {
  // weight * integral R_uu . R_vv
  Random random{2};
  const Knots knots = someKnots();
  const energy::EnergyTerms mixed = {{3.0, {2, 0}, {0, 2}}};
  const MatrixXd h = denseEnergy(knots, mixed);
  EXPECT_LT((h - h.transpose()).norm(), 1e-14 * h.norm());
  const BsplineSurface surface = randomSurface(random, knots.u, knots.v);
  const double expected = 1.5 * integral(surface, 12, [&](double u, double v) {
                            const spline::SurfaceJet r = surface.jet(u, v);
                            return r.uu.dot(r.vv);
                          });
  EXPECT_NEAR(quadraticForm(assembleEnergy(freePatch(knots.u, knots.v), mixed), surface.poles),
              expected,
              1e-11 * h.norm());
}

TEST(AssembleEnergy, FinerKnotsGiveTheSameSurfaceTheSameEnergy) {
  Random random{3};
  const Knots knots = someKnots();
  const BsplineSurface coarse = randomSurface(random, knots.u, knots.v);
  const BsplineSurface fine =
      spline::refinedTo(coarse, knots.u.withKnot(0.4).withKnot(1.1), knots.v.withKnot(0.2));
  const double before =
      quadraticForm(assembleEnergy(freePatch(coarse.u, coarse.v), thinPlate()), coarse.poles);
  EXPECT_NEAR(quadraticForm(assembleEnergy(freePatch(fine.u, fine.v), thinPlate()), fine.poles),
              before,
              1e-11 * before);
}

}  // namespace
}  // namespace fairing::assembly
