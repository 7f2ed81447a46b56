// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/assemble_shape_energy.h"

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "core/analysis/measure_fairness.h"
#include "core/shape_energy/mean_curvature_gradient.h"
#include "core/shape_energy/minimum_variation.h"
#include "core/spline/quadrature.h"
#include "support/known_surface.h"
#include "support/matchers.h"
#include "support/numerical_derivative.h"
#include "support/quadratic_forms.h"
#include "support/random_splines.h"

namespace fairing::assembly {
namespace {

using namespace ::fairing::testing;  // NOLINT: known surfaces, random splines, quadratic forms
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using spline::BsplineSurface;
using spline::KnotVector;

const shape_energy::MeanCurvatureGradient kEnergy;

// Uneven spans, different degrees, a repeated knot; bumpy, and no height field.
BsplineSurface bumpyPatch() {
  Random random{0};
  const KnotVector u = randomKnots(random, 5, 2, 2).mapped(0.0, 1.5);
  const KnotVector v = randomKnots(random, 4, 2).mapped(0.0, 0.8);
  return randomSurface(random, u, v, 0.05);
}

KnotVector evenKnots(int degree, int spans) {
  std::vector<double> breaks;
  for (int i = 0; i <= spans; ++i) breaks.push_back(static_cast<double>(i) / spans);
  return KnotVector::fromBreaks(degree, breaks);
}

BsplineSurface splineOf(const KnownSurface& surface, const KnotVector& knots) {
  return interpolated([&](double u, double v) { return surface(u, v).point; }, knots, knots);
}

// The elements summed, 3 coordinates a point.
struct Total {
  double value = 0.0;
  VectorXd gradient;
  MatrixXd hessian;
};

Total totalOf(const layout::PatchLayout& layout, const std::vector<ShapeElement>& elements) {
  const Eigen::Index size = 3 * layout.pointCount;
  Total total{0.0, VectorXd::Zero(size), MatrixXd::Zero(size, size)};
  for (const ShapeElement& e : elements) {
    total.value += e.value;
    for (std::size_t a = 0; a < e.points.size(); ++a) {
      const auto row = 3 * static_cast<Eigen::Index>(a);
      total.gradient.segment<3>(3 * e.points[a]) += e.gradient.segment<3>(row);
      for (std::size_t b = 0; b < e.points.size(); ++b)
        total.hessian.block<3, 3>(3 * e.points[a], 3 * e.points[b]) +=
            e.hessian.block<3, 3>(row, 3 * static_cast<Eigen::Index>(b));
    }
  }
  return total;
}

Total totalOf(const layout::PatchLayout& layout,
              const std::vector<BsplineSurface>& patches,
              int points = 0) {
  return totalOf(layout, assembleShapeEnergy(layout, patches, kEnergy, points));
}

Total totalOf(const BsplineSurface& patch, int points = 0) {
  return totalOf(freePatch(patch.u, patch.v), {patch}, points);
}

double energyOf(const BsplineSurface& patch, int points = 0) {
  return shapeEnergyOf({patch}, kEnergy, points);
}

BsplineSurface displaced(BsplineSurface patch, const VectorXd& by) {
  patch.poles += unflattened(by);
  return patch;
}

// The weighted residuals of all quadrature points, by means of the test's own.
VectorXd residualsOf(const BsplineSurface& patch, int points) {
  std::vector<double> all;
  for (const auto& qu : spline::gaussLegendre(points, patch.u))
    for (const auto& qv : spline::gaussLegendre(points, patch.v)) {
      const auto jet = spline::thirdOrderJet(patch.derivatives(qu.parameter, qv.parameter, 3));
      for (const double r : kEnergy.residuals(jet))
        all.push_back(std::sqrt(qu.weight * qv.weight) * r);
    }
  return Eigen::Map<VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

TEST(AssembleShapeEnergy, OneElementASpanWithItsControlPoints) {
  const BsplineSurface patch = bumpyPatch();
  const auto elements = assembleShapeEnergy(freePatch(patch.u, patch.v), {patch}, kEnergy);
  ASSERT_EQ(elements.size(), 4U);
  for (const ShapeElement& e : elements) {
    EXPECT_EQ(e.points.size(), 30U);
    EXPECT_EQ(e.gradient.size(), 90);
    EXPECT_EQ(e.hessian, e.hessian.transpose());
  }
}

TEST(AssembleShapeEnergy, ValueIsTheEnergyAlone) {
  const BsplineSurface patch = bumpyPatch();
  for (const int points : {0, 2, 6})
    EXPECT_NEAR(totalOf(patch, points).value / energyOf(patch, points), 1.0, 1e-12);
}

TEST(AssembleShapeEnergy, EnergyIsTheOneMeasured) {
  const BsplineSurface patch = bumpyPatch();
  // The analysis takes sixteen points over two spans: by the same ones they agree to rounding.
  EXPECT_NEAR(energyOf(patch, 8) / analysis::measureFairness({patch}, 1.0).meanCurvatureGradient,
              1.0,
              1e-12);
}

TEST(AssembleShapeEnergy, GradientIsThatOfDifferences) {
  const BsplineSurface patch = bumpyPatch();
  const Total total = totalOf(patch);
  for (Eigen::Index k = 0; k < total.gradient.size(); ++k) {
    const VectorXd unit = VectorXd::Unit(total.gradient.size(), k);
    const double numerical =
        derivative([&](double x) { return energyOf(displaced(patch, x * unit)); }, 0.0, 1e-5);
    EXPECT_NEAR(total.gradient[k], numerical, 1e-6 * total.gradient.cwiseAbs().maxCoeff());
  }
}

TEST(AssembleShapeEnergy, HessianIsTwiceTheSquareOfTheResidualsSlopes) {
  const BsplineSurface patch = bumpyPatch();
  const Total total = totalOf(patch, 4);
  MatrixXd jacobian(residualsOf(patch, 4).size(), total.gradient.size());
  for (Eigen::Index k = 0; k < jacobian.cols(); ++k) {
    const VectorXd unit = VectorXd::Unit(jacobian.cols(), k);
    jacobian.col(k) =
        derivative([&](double x) { return residualsOf(displaced(patch, x * unit), 4); }, 0.0, 1e-5);
  }
  const MatrixXd expected = 2.0 * jacobian.transpose() * jacobian;
  EXPECT_THAT(total.hessian, IsNear(expected, 1e-6 * expected.cwiseAbs().maxCoeff()));
}

Total expansionOf(const BsplineSurface& patch, const shape_energy::ShapeEnergy& energy) {
  const layout::PatchLayout layout = freePatch(patch.u, patch.v);
  return totalOf(layout, expandShapeEnergy(layout, {patch}, energy));
}

TEST(AssembleShapeEnergy, ExpansionIsThatOfDifferences) {
  const BsplineSurface patch = bumpyPatch();
  const shape_energy::MinimumVariation variation(1.0);
  for (const shape_energy::ShapeEnergy* energy :
       {static_cast<const shape_energy::ShapeEnergy*>(&kEnergy),
        static_cast<const shape_energy::ShapeEnergy*>(&variation)}) {
    const Total total = expansionOf(patch, *energy);
    EXPECT_NEAR(total.value / shapeEnergyOf({patch}, *energy), 1.0, 1e-12);
    Random random{3};
    for (int times = 0; times < 3; ++times) {
      const VectorXd along = randomMatrix(random, total.gradient.size(), 1);
      const VectorXd expected = derivative(
          [&](double x) { return expansionOf(displaced(patch, x * along), *energy).gradient; },
          0.0,
          1e-5);
      EXPECT_THAT(VectorXd(total.hessian * along),
                  IsNear(expected, 1e-6 * expected.cwiseAbs().maxCoeff()));
    }
    EXPECT_EQ(total.hessian, total.hessian.transpose());
  }
}

TEST(AssembleShapeEnergy, ExpansionHasTheGradientOfTheModel) {
  const BsplineSurface patch = bumpyPatch();
  const Total total = totalOf(patch), expansion = expansionOf(patch, kEnergy);
  EXPECT_THAT(expansion.gradient,
              IsNear(total.gradient, 1e-11 * total.gradient.cwiseAbs().maxCoeff()));
}

// Spans are worked on side by side; who takes which must not matter.
TEST(AssembleShapeEnergy, IsTheSameEveryTime) {
  const BsplineSurface patch = bumpyPatch();
  const Total total = totalOf(patch);
  const double energy = energyOf(patch);
  for (int times = 0; times < 20; ++times) {
    EXPECT_EQ(totalOf(patch).hessian, total.hessian);
    EXPECT_EQ(energyOf(patch), energy);
  }
}

TEST(AssembleShapeEnergy, NamesThePointsOfEverySpan) {
  const BsplineSurface patch = bumpyPatch();
  const layout::PatchLayout layout = freePatch(patch.u, patch.v);
  const auto points = spanPoints(layout);
  const auto elements = assembleShapeEnergy(layout, {patch}, kEnergy);
  ASSERT_EQ(points.size(), elements.size());
  for (std::size_t k = 0; k < points.size(); ++k) EXPECT_EQ(points[k], elements[k].points);
}

TEST(AssembleShapeEnergy, RigidMotionsChangeNothing) {
  const BsplineSurface patch = bumpyPatch();
  const Total total = totalOf(patch);
  const double scale = total.hessian.cwiseAbs().maxCoeff();
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d d = Vector3d::Unit(axis);
    spline::Poles shift = patch.poles, turn = patch.poles;
    for (Eigen::Index i = 0; i < patch.poles.rows(); ++i) {
      shift.row(i) = d.transpose();
      turn.row(i) = d.cross(Vector3d(patch.poles.row(i))).transpose();
    }
    for (const auto& motion : {flattened(shift), flattened(turn)}) {
      EXPECT_LT((total.hessian * motion).norm(), 1e-10 * scale);
      EXPECT_LT(std::abs(total.gradient.dot(motion)), 1e-10 * total.gradient.norm());
    }
  }
}

TEST(AssembleShapeEnergy, FallsWithTheSquareOfTheSize) {
  BsplineSurface patch = bumpyPatch();
  const double before = energyOf(patch);
  patch.poles *= 50.0;
  EXPECT_NEAR(energyOf(patch) * 2500.0 / before, 1.0, 1e-11);
}

TEST(AssembleShapeEnergy, DoesNotDependOnDomainOrDirection) {
  const BsplineSurface patch = bumpyPatch();
  const double expected = energyOf(patch);
  EXPECT_NEAR(energyOf(transposed(patch)) / expected, 1.0, 1e-11);
  BsplineSurface wide = patch;
  wide.u = patch.u.mapped(-3.0, 4.0);
  EXPECT_NEAR(energyOf(wide) / expected, 1.0, 1e-11);
}

TEST(AssembleShapeEnergy, VanishesOnSurfacesOfConstantMeanCurvature) {
  const KnotVector knots = evenKnots(9, 4);
  for (const KnownSurface& surface : {plane(), sphere(1.0), cylinder(1.0)}) {
    const BsplineSurface patch = splineOf(surface, knots);
    const Total total = totalOf(patch);
    EXPECT_LT(total.value, 1e-9);  // how well the spline is the surface
    EXPECT_TRUE(total.hessian.allFinite());
  }
}

// Where the residuals vanish, the Gauss-Newton model is the second-order expansion itself.
TEST(AssembleShapeEnergy, GaussNewtonIsExactAboutAPlane) {
  Random random{1};
  const KnotVector knots = evenKnots(5, 2);
  const BsplineSurface flat = splineOf(plane(), knots);
  const VectorXd by = 1e-5 * flattened(randomSurface(random, knots, knots).poles - flat.poles);
  const Total total = totalOf(flat);
  const double model = 0.5 * by.dot(total.hessian * by);
  EXPECT_NEAR(energyOf(displaced(flat, by)) / model, 1.0, 1e-2);
}

// On a level patch the energy is that of grad Laplace h; with two points less than the degree some
// of its modes go unseen.
TEST(AssembleShapeEnergy, DefaultQuadratureLeavesNoSpuriousZeroModes) {
  for (const int degree : {3, 4, 5, 7}) {
    const BsplineSurface flat = splineOf(plane(), evenKnots(degree, 1));
    const auto rankOf = [&](int points) {
      const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(totalOf(flat, points).hessian,
                                                           Eigen::EigenvaluesOnly);
      return (solver.eigenvalues().array() > 1e-10 * solver.eigenvalues().maxCoeff()).count();
    };
    EXPECT_EQ(rankOf(0), rankOf(12)) << degree;
  }
}

TEST(AssembleShapeEnergy, DefaultQuadratureIsGoodToAThousandth) {
  for (const int degree : {3, 5, 7}) {
    const BsplineSurface patch = splineOf(waves(), evenKnots(degree, 2));
    EXPECT_NEAR(energyOf(patch) / energyOf(patch, 24), 1.0, 1e-3) << degree;
  }
}

// Every point more is worth a factor of fifty and more; Lobatto's rule with one more is as good as
// Gauss's. What steps to the minimum take, two more than the degree, leaves rounding alone.
TEST(AssembleShapeEnergy, TheValueConvergesWithTheOrderOfTheRule) {
  using spline::QuadratureFamily;
  const BsplineSurface patch = splineOf(waves(), evenKnots(5, 2));
  const double exact = energyOf(patch, 24);
  const auto off = [&](int points, QuadratureFamily family) {
    return std::abs(shapeEnergyOf({patch}, kEnergy, {points, family}) / exact - 1.0);
  };
  for (int points = 4; points <= 6; ++points) {
    const double gauss = off(points, QuadratureFamily::Gauss);
    const double lobatto = off(points + 1, QuadratureFamily::Lobatto);
    EXPECT_LT(off(points + 1, QuadratureFamily::Gauss), 0.02 * gauss);
    EXPECT_LT(off(points + 2, QuadratureFamily::Lobatto), 0.02 * lobatto);
    EXPECT_LT(lobatto, 3.0 * gauss);
  }
  EXPECT_LT(off(7, QuadratureFamily::Gauss), 1e-11);
}

TEST(AssembleShapeEnergy, PointsAreNumberedAsInTheLayout) {
  const BsplineSurface patch = bumpyPatch();
  layout::PatchLayout layout = freePatch(patch.u, patch.v);
  const layout::LayoutPatch first = layout.patches[0];
  layout.patches.push_back(first);  // the same patch twice, its points numbered backwards
  for (int& number : layout.patches[1].points) number = 2 * layout.pointCount - 1 - number;
  const int count = layout.pointCount;
  layout.pointCount *= 2;
  const Total both = totalOf(layout, {patch, patch}), one = totalOf(patch);
  EXPECT_NEAR(both.value / one.value, 2.0, 1e-12);
  EXPECT_EQ(both.gradient.head(3 * count), one.gradient);
  for (int i = 0; i < count; ++i)
    EXPECT_EQ(both.gradient.segment<3>(3 * (2 * count - 1 - i)), one.gradient.segment<3>(3 * i));
}

}  // namespace
}  // namespace fairing::assembly
