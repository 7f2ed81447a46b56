// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the quadratic energies are known to do: exact solutions and limits of the weights.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <complex>

#include "core/assembly/assemble_energy.h"
#include "core/assembly/assemble_guidance.h"
#include "core/solver/solve.h"
#include "support/matchers.h"
#include "support/quadratic_forms.h"
#include "support/random_splines.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: random splines and quadratic forms
using Eigen::Vector3d;
using spline::BsplineSurface;
using spline::KnotVector;

// The minimiser that keeps the outer `rows` rows of a surface's poles.
BsplineSurface minimiser(const BsplineSurface& border,
                         const energy::EnergyTerms& terms,
                         int rows,
                         const energy::Guidance& guidance = {}) {
  const auto layout = freePatch(border.u, border.v);
  solver::QuadraticProgram program =
      holdingBorder(border, assembly::assembleEnergy(layout, terms), rows);
  if (guidance.acts()) {
    const auto guided = assembly::assembleGuidance(layout, guidance, {border});
    program.coupled = guided.coupled();
    program.load = guided.load;
  }
  const auto solution = solver::solve(program);
  EXPECT_TRUE(solution.has_value());
  return {border.u, border.v, solution ? solution->points : border.poles};
}

// The surface with its inner poles spoilt: the solver must not see the answer.
BsplineSurface borderAlone(const BsplineSurface& surface, int rows) {
  BsplineSurface spoilt = surface;
  const auto program = holdingBorder(surface, {}, rows);
  for (std::size_t p = 0; p < program.fixed.size(); ++p)
    if (!program.fixed[p]) spoilt.poles.row(static_cast<Eigen::Index>(p)).setConstant(7.0);
  return spoilt;
}

struct Grid {
  KnotVector u, v;
};

// Uneven, of different degrees.
Grid someGrid() {
  Random random{0};
  const KnotVector u = randomKnots(random, 5, 3), v = randomKnots(random, 6, 2);
  return {u, v};
}

// Real and imaginary parts of (u + iv)^k: the harmonic polynomials.
double re(int k, double u, double v) {
  return std::pow(std::complex<double>(u, v), k).real();
}
double im(int k, double u, double v) {
  return std::pow(std::complex<double>(u, v), k).imag();
}

TEST(Membrane, ReproducesEveryHarmonicPolynomialFromItsBorder) {
  const Grid g = someGrid();
  for (int k = 1; k <= 5; ++k) {
    const BsplineSurface exact = interpolated(
        [k](double u, double v) { return Vector3d(re(k, u, v), im(k, u, v), u - 2.0 * v); },
        g.u,
        g.v);
    const BsplineSurface got = minimiser(borderAlone(exact, 1), energy::membrane(), 1);
    EXPECT_THAT(got.poles, IsNear(exact.poles, 1e-11)) << "power " << k;
  }
}

TEST(Membrane, GivesTheBilinearPatchForBilinearData) {
  const Grid g = someGrid();
  const BsplineSurface exact = interpolated(
      [](double u, double v) {
        return Vector3d(u + 0.3 * v, v - 0.2 * u * v, 1.0 + u - 3.0 * u * v);
      },
      g.u,
      g.v);
  EXPECT_THAT(minimiser(borderAlone(exact, 1), energy::membrane(), 1).poles,
              IsNear(exact.poles, 1e-12));
}

TEST(Membrane, IsTheDiscreteHarmonicPatch) {
  // No inner basis function feels a force: integral of grad B . grad R = 0.
  Random random{1};
  const Grid g = someGrid();
  const BsplineSurface r = minimiser(randomSurface(random, g.u, g.v), energy::membrane(), 1);
  const spline::Poles force =
      assembly::assembleEnergy(freePatch(g.u, g.v), energy::membrane()) * r.poles;
  for (int i = 1; i < g.u.poleCount() - 1; ++i)
    for (int j = 1; j < g.v.poleCount() - 1; ++j) EXPECT_LT(force.row(r.index(i, j)).norm(), 1e-12);
}

TEST(ThinPlate, ReproducesEveryBiharmonicPolynomialFromBorderAndNormalDerivative) {
  const Grid g = someGrid();
  // Harmonic polynomials h and (u^2 + v^2) h: every biharmonic one is a sum of these.
  for (int k = 0; k <= 3; ++k) {
    const BsplineSurface exact = interpolated(
        [k](double u, double v) {
          const double r2 = u * u + v * v;
          return Vector3d(re(k + 2, u, v) + r2 * re(k, u, v), im(k + 2, u, v), r2 * im(k, u, v));
        },
        g.u,
        g.v);
    const BsplineSurface got = minimiser(borderAlone(exact, 2), energy::thinPlate(), 2);
    EXPECT_THAT(got.poles, IsNear(exact.poles, 1e-11)) << "power " << k;
  }
}

TEST(Triharmonic, ReproducesEveryTriharmonicPolynomialFromBorderAndTwoDerivatives) {
  const Grid g = someGrid();
  // Harmonic polynomials h, (u^2 + v^2) h and (u^2 + v^2)^2 h: every triharmonic one is a sum of
  // these.
  for (int k = 0; k <= 1; ++k) {
    const BsplineSurface exact = interpolated(
        [k](double u, double v) {
          const double r2 = u * u + v * v;
          return Vector3d(
              re(k + 2, u, v) + r2 * re(k, u, v), r2 * im(k, u, v), r2 * r2 * re(k, u, v));
        },
        g.u,
        g.v);
    const BsplineSurface got = minimiser(borderAlone(exact, 3), energy::triharmonic(), 3);
    EXPECT_THAT(got.poles, IsNear(exact.poles, 1e-10)) << "power " << k;
  }
}

TEST(ThinPlate, DoesNotReproduceWhatIsNotBiharmonic) {
  const Grid g = someGrid();
  const BsplineSurface other =
      interpolated([](double u, double v) { return Vector3d(u, v, std::pow(u * v, 4)); }, g.u, g.v);
  const BsplineSurface got = minimiser(borderAlone(other, 2), energy::thinPlate(), 2);
  EXPECT_GT((got.poles - other.poles).norm(), 1e-4);
}

TEST(ThinPlate, GivesTheBilinearPatchForBilinearData) {
  const Grid g = someGrid();
  const BsplineSurface exact = interpolated(
      [](double u, double v) { return Vector3d(u, v, 1.0 + u - 3.0 * u * v); }, g.u, g.v);
  EXPECT_THAT(minimiser(borderAlone(exact, 2), energy::thinPlate(), 2).poles,
              IsNear(exact.poles, 1e-11));
}

class EveryEnergy : public ::testing::TestWithParam<EnergyKind> {
 protected:
  energy::EnergyTerms terms_ = energy::energyTerms(GetParam());
  int rows_ = GetParam() == EnergyKind::Membrane ? 1 : 2;

  [[nodiscard]] double energyOf(const BsplineSurface& surface) const {
    return quadraticForm(assembly::assembleEnergy(freePatch(surface.u, surface.v), terms_),
                         surface.poles);
  }
};

TEST_P(EveryEnergy, NoFeasiblePerturbationHasLess) {
  Random random{2};
  const Grid g = someGrid();
  const BsplineSurface best = minimiser(randomSurface(random, g.u, g.v), terms_, rows_);
  const auto program = holdingBorder(best, {}, rows_);
  for (int k = 0; k < 100; ++k) {
    BsplineSurface other = best;
    for (std::size_t p = 0; p < program.fixed.size(); ++p)
      if (!program.fixed[p])
        other.poles.row(static_cast<Eigen::Index>(p)) += 0.01 * randomVector(random).transpose();
    EXPECT_GT(energyOf(other), energyOf(best));
  }
}

TEST_P(EveryEnergy, NeverRisesWhenKnotsAreAdded) {
  // On finer knots the same border leaves the solver at least the coarse solution.
  Random random{3};
  const Grid g = someGrid();
  BsplineSurface surface = minimiser(randomSurface(random, g.u, g.v), terms_, rows_);
  double before = energyOf(surface);
  for (const double knot : {0.5, 0.25, 0.75, 0.4, 0.6}) {
    surface = spline::refinedTo(surface, surface.u.withKnot(knot), surface.v.withKnot(1.0 - knot));
    // Only the border of the coarse solution is kept; its cross derivative for the thin plate.
    surface = minimiser(surface, terms_, rows_);
    const double now = energyOf(surface);
    EXPECT_LE(now, before * (1.0 + 1e-12));
    before = now;
  }
}

TEST_P(EveryEnergy, NeverRisesWhenTheDegreeIsRaised) {
  Random random{4};
  const Grid g = someGrid();
  const BsplineSurface coarse = minimiser(randomSurface(random, g.u, g.v), terms_, rows_);
  const BsplineSurface fine = minimiser(spline::raiseDegree(coarse, 1, 1), terms_, rows_);
  EXPECT_LE(energyOf(fine), energyOf(coarse) * (1.0 + 1e-12));
}

TEST_P(EveryEnergy, LargeGammaGivesTheReference) {
  Random random{5};
  const Grid g = someGrid();
  const BsplineSurface reference = randomSurface(random, g.u, g.v);
  energy::Guidance guidance;
  guidance.continuous = {reference, reference};
  double before = 1.0;
  for (const double gamma : {1e2, 1e4, 1e6, 1e8}) {
    guidance.gamma = gamma;
    const BsplineSurface got = minimiser(borderAlone(reference, rows_), terms_, rows_, guidance);
    const double off = (got.poles - reference.poles).cwiseAbs().maxCoeff();
    EXPECT_LT(off, before);
    before = off;
  }
  // R - S = O(1 / gamma) times the energy's own force on S, about 1e5 for these rough poles.
  EXPECT_LT(before, 1e-2);
}

TEST_P(EveryEnergy, DistanceToTheReferenceFallsLikeOneOverGamma) {
  Random random{6};
  const Grid g = someGrid();
  const BsplineSurface reference = randomSurface(random, g.u, g.v);
  energy::Guidance guidance;
  guidance.continuous = {reference, reference};
  const auto offAt = [&](double gamma) {
    guidance.gamma = gamma;
    return (minimiser(borderAlone(reference, rows_), terms_, rows_, guidance).poles -
            reference.poles)
        .norm();
  };
  // Already asymptotic at 1e10: a factor of 100 in gamma takes a factor of 100 off.
  EXPECT_NEAR(std::log10(offAt(1e10) / offAt(1e12)), 2.0, 0.1);
}

// S with its own normals: the tilt of R against them, integrated.
double tilt(const BsplineSurface& r, const BsplineSurface& normals) {
  return std::sqrt(integral(r, 8, [&](double u, double v) {
    const spline::SurfaceJet jet = r.jet(u, v);
    const Vector3d n = normals.evaluate(u, v);
    return std::pow(jet.u.dot(n), 2) + std::pow(jet.v.dot(n), 2);
  }));
}

TEST_P(EveryEnergy, LargeLambdaTurnsTheSurfaceToTheGuidingNormals) {
  // z = u^3 v^2 and its normals (-3 u^2 v^2, -2 u^3 v, 1): polynomials, so S itself has no tilt at
  // all and no energy keeps the solution from it as lambda grows.
  const Grid g = someGrid();
  const BsplineSurface s =
      interpolated([](double u, double v) { return Vector3d(u, v, u * u * u * v * v); }, g.u, g.v);
  const KnotVector cubic = KnotVector::bezier(3);
  const BsplineSurface normals = interpolated(
      [](double u, double v) { return Vector3d(-3.0 * u * u * v * v, -2.0 * u * u * u * v, 1.0); },
      cubic,
      cubic);
  ASSERT_LT(tilt(s, normals), 1e-12);
  energy::Guidance guidance;
  guidance.continuous = {normals, s};
  const BsplineSurface free = minimiser(borderAlone(s, rows_), terms_, rows_);
  double before = tilt(free, normals);
  ASSERT_GT(before, 1e-3);
  for (const double lambda : {1e1, 1e3, 1e5, 1e7}) {
    guidance.lambda = lambda;
    const double now = tilt(minimiser(borderAlone(s, rows_), terms_, rows_, guidance), normals);
    EXPECT_LT(now, before);
    before = now;
  }
  EXPECT_LT(before, 1e-5);
}

TEST_P(EveryEnergy, DiscreteNormalsTurnTheSurfaceToo) {
  const Grid g = someGrid();
  const BsplineSurface s =
      interpolated([](double u, double v) { return Vector3d(u, v, u * u * u * v * v); }, g.u, g.v);
  energy::DiscreteGuidance grid;
  grid.n = grid.m = 20;
  const int count = 21 * 21;
  grid.normals.resize(count, 3);
  grid.points.setZero(count, 3);
  grid.lambda = Eigen::VectorXd::Ones(count);
  grid.gamma = Eigen::VectorXd::Zero(count);
  for (int k = 0; k < count; ++k) {
    const double u = k / 21 / 20.0, v = k % 21 / 20.0;
    grid.normals.row(k) = s.jet(u, v).normalVector().normalized().transpose();
  }
  energy::Guidance guidance;
  guidance.discrete = grid;
  guidance.lambda = 1e6;
  const BsplineSurface got = minimiser(borderAlone(s, rows_), terms_, rows_, guidance);
  for (const double u : {0.13, 0.52, 0.87})
    for (const double v : {0.21, 0.66}) {
      const Vector3d a = got.jet(u, v).normalVector().normalized();
      const Vector3d b = s.jet(u, v).normalVector().normalized();
      EXPECT_LT(a.cross(b).norm(), 1e-4);  // radians, against the true normal
    }
}

INSTANTIATE_TEST_SUITE_P(Energies,
                         EveryEnergy,
                         ::testing::Values(EnergyKind::Membrane, EnergyKind::ThinPlate),
                         [](const auto& instance) {
                           return instance.param == EnergyKind::Membrane ? "Membrane" : "ThinPlate";
                         });

}  // namespace
}  // namespace fairing
