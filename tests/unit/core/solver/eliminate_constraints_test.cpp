// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/eliminate_constraints.h"

#include <gmock/gmock.h>

#include <Eigen/QR>

#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::solver {
namespace {

using namespace ::fairing::testing;  // NOLINT: random numbers
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kPoints = 8;

LinearRow randomRow(Random& random, const std::vector<int>& points) {
  LinearRow row{points, {}, randomNumber(random)};
  for (std::size_t k = 0; k < points.size(); ++k) row.weights.push_back(randomVector(random));
  return row;
}

// Point 0 fixed; a first block for 1 and 2, and one for 3 that leans on 2 and on 5.
QuadraticProgram someProgram() {
  Random random{0};
  QuadraticProgram program;
  program.fixed.assign(kPoints, 0);
  program.fixed[0] = 1;
  program.values = randomMatrix(random, kPoints, 3);
  program.blocks = {{{randomRow(random, {0, 1, 2}), randomRow(random, {1, 2})}, {1, 2}},
                    {{randomRow(random, {2, 3, 5})}, {3}}};
  return program;
}

double residual(const LinearRow& row, const VectorXd& x) {
  double sum = -row.right;
  for (std::size_t k = 0; k < row.points.size(); ++k)
    sum += row.weights[k].dot(x.segment<3>(3 * row.points[k]));
  return std::abs(sum);
}

TEST(EliminateConstraints, EveryPointOfTheSpaceMeetsEveryRow) {
  const QuadraticProgram program = someProgram();
  const AffineSpace space = eliminateConstraints(program);
  Random random{1};
  for (int k = 0; k < 10; ++k) {
    const VectorXd x = space.offset + space.basis * randomMatrix(random, space.basis.cols(), 1);
    for (const ConstraintBlock& block : program.blocks)
      for (const LinearRow& row : block.rows) EXPECT_LT(residual(row, x), 1e-12);
    EXPECT_THAT(Vector3d(x.head<3>()), IsNear(Vector3d(program.values.row(0)), 0.0));
  }
}

TEST(EliminateConstraints, LeavesAsManyCoordinatesAsTheRowsDoNotTake) {
  const AffineSpace space = eliminateConstraints(someProgram());
  EXPECT_EQ(space.rows, 3);
  EXPECT_EQ(space.basis.cols(), 3 * kPoints - 3 - 3);
  const Eigen::MatrixXd basis = space.basis;
  EXPECT_EQ(basis.colPivHouseholderQr().rank(), basis.cols());
}

TEST(EliminateConstraints, MarksThePointsThatTakePart) {
  EXPECT_THAT(eliminateConstraints(someProgram()).bound,
              ::testing::ElementsAre(1, 1, 1, 1, 0, 1, 0, 0));
}

TEST(EliminateConstraints, WithoutRowsEverythingIsFree) {
  QuadraticProgram program = someProgram();
  program.fixed.assign(kPoints, 0);
  program.blocks.clear();
  const AffineSpace space = eliminateConstraints(program);
  EXPECT_EQ(space.basis.cols(), 3 * kPoints);
  EXPECT_EQ(space.offset.norm(), 0.0);
}

TEST(EliminateConstraints, ABlockWithoutRowsIsNoMatter) {
  // The sides of a bicubic Bezier patch: their inner points all belong to the corners.
  QuadraticProgram program = someProgram();
  program.blocks.push_back({});
  EXPECT_EQ(eliminateConstraints(program).rows, 3);
}

TEST(EliminateConstraints, RowsOfKnownPointsAloneAreChecked) {
  QuadraticProgram program = someProgram();
  const LinearRow agrees{{0}, {Vector3d::UnitX()}, program.values(0, 0)};
  program.blocks.push_back({{agrees}, {0}});
  EXPECT_LT(eliminateConstraints(program).residual, 1e-12);
  program.blocks.back().rows[0].right += 0.25;
  EXPECT_NEAR(eliminateConstraints(program).residual, 0.25, 1e-12);
}

}  // namespace
}  // namespace fairing::solver
