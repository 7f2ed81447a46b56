// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Halving the spans: the rates with which deviations and solutions converge.
#include <gmock/gmock.h>

#include <cmath>

#include "core/assembly/assemble_energy.h"
#include "core/constraint/constraint_set.h"
#include "core/layout/build_layout.h"
#include "core/layout/layouts.h"
#include "core/solver/solve.h"
#include "support/known_loops.h"
#include "support/measure.h"
#include "support/quadratic_forms.h"
#include "support/random_splines.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using Eigen::Vector3d;
using spline::BsplineSurface;
using spline::KnotVector;

KnotVector uniformKnots(int degree, int spans) {
  std::vector<double> breaks;
  for (int s = 0; s <= spans; ++s) breaks.push_back(static_cast<double>(s) / spans);
  return KnotVector::fromBreaks(degree, breaks);
}

BsplineSurface fillOnUniformKnots(const boundary::BoundaryLoop& loop, int degree, int spans) {
  const KnotVector knots = uniformKnots(degree, spans);
  const auto layout =
      layout::buildLayout(*layout::planLayout(loop, LayoutKind::Quad), {knots, knots});
  const auto set = constraint::constrainSides(loop, layout);
  solver::QuadraticProgram program;
  program.stiffness = assembly::assembleEnergy(layout, energy::thinPlate());
  program.fixed = set->fixed;
  program.values = set->values;
  program.blocks = set->blocks;
  const auto solution = solver::solve(program);
  return {layout.patches[0].u, layout.patches[0].v, solution->points};
}

double slope(double coarse, double fine) {
  return std::log2(coarse / fine);
}

class SideRate : public ::testing::TestWithParam<int> {
 protected:
  boundary::BoundaryLoop loop_ = loopOf(waves(), unevenQuadrilateral(), 0.08);
  [[nodiscard]] BsplineSurface fill(int spans) const {
    return fillOnUniformKnots(loop_, GetParam(), spans);
  }
  // Degrees, over the middle half of the sides.
  [[nodiscard]] double angleInTheMiddle(int spans) const {
    const BsplineSurface patch = fill(spans);
    double worst = 0.0;
    for (std::size_t side = 0; side < 4; ++side)
      worst = std::max(worst, deviationOf(loop_, patch, side, 0.25, 0.75).angle);
    return worst;
  }
};

TEST_P(SideRate, OfTheGapIsTheOrderOfTheFit) {
  const double coarse = deviationOf(loop_, fill(4)).gap, fine = deviationOf(loop_, fill(8)).gap;
  // Order p + 1; measured 4.05, 4.75, 6.2, 7.3 for p = 3 to 6.
  EXPECT_GT(slope(coarse, fine), GetParam() + 0.5) << coarse << " to " << fine;
}

TEST_P(SideRate, OfTheAngleIsTwoWithTheCorners) {
  // A clamped plate is not smooth in its corners, whatever the degree: that leaves order two.
  // Measured over two halvings: 2.2, 2.15, 2.1, 2.15 for p = 3 to 6.
  const double coarse = deviationOf(loop_, fill(4)).angle;
  const double fine = deviationOf(loop_, fill(16)).angle;
  EXPECT_GT(0.5 * slope(coarse, fine), 1.9) << coarse << " to " << fine << " degrees";
}

TEST_P(SideRate, OfTheAngleIsAboutThreeInTheMiddle) {
  // Measured 3.1, 3.5, 3.3, 2.8 for p = 3 to 6.
  const double coarse = angleInTheMiddle(8), fine = angleInTheMiddle(16);
  EXPECT_GT(slope(coarse, fine), 2.5) << coarse << " to " << fine << " degrees";
}

INSTANTIATE_TEST_SUITE_P(Degrees, SideRate, ::testing::Values(3, 4, 5, 6));

// The largest distance between two surfaces over the same domain.
double difference(const BsplineSurface& patch, const PointFunction& exact) {
  double worst = 0.0;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j)
      worst =
          std::max(worst, (patch.evaluate(i / 20.0, j / 20.0) - exact(i / 20.0, j / 20.0)).norm());
  return worst;
}

double solutionError(
    const PointFunction& exact, const energy::EnergyTerms& terms, int rows, int degree, int spans) {
  const KnotVector knots = uniformKnots(degree, spans);
  const BsplineSurface border = interpolated(exact, knots, knots);
  const auto stiffness = assembly::assembleEnergy(freePatch(knots, knots), terms);
  const auto solution = solver::solve(holdingBorder(border, stiffness, rows));
  return difference({knots, knots, solution->points}, exact);
}

class SolutionRate : public ::testing::TestWithParam<int> {};

TEST_P(SolutionRate, OfTheMembraneToAHarmonicSurface) {
  const int degree = GetParam();
  const PointFunction harmonic = [](double u, double v) {
    return Vector3d(u, v, std::exp(2.0 * u) * std::sin(2.0 * v));
  };
  const double coarse = solutionError(harmonic, energy::membrane(), 1, degree, 4);
  const double fine = solutionError(harmonic, energy::membrane(), 1, degree, 8);
  // Galerkin on splines of degree p: order p + 1 in the values.
  EXPECT_GT(slope(coarse, fine), degree + 0.5) << coarse << " to " << fine;
}

TEST_P(SolutionRate, OfTheThinPlateToABiharmonicSurface) {
  const int degree = GetParam();
  const PointFunction biharmonic = [](double u, double v) {
    return Vector3d(u, v, u * std::exp(2.0 * u) * std::sin(2.0 * v));
  };
  const double coarse = solutionError(biharmonic, energy::thinPlate(), 2, degree, 4);
  const double fine = solutionError(biharmonic, energy::thinPlate(), 2, degree, 8);
  // The border's derivative, taken from an interpolant, is good to order p.
  EXPECT_GT(slope(coarse, fine), degree - 0.5) << coarse << " to " << fine;
}

INSTANTIATE_TEST_SUITE_P(Degrees, SolutionRate, ::testing::Values(4, 5, 6));

}  // namespace
}  // namespace fairing
