// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/tie_points.h"

#include <gmock/gmock.h>

#include "core/solver/solve.h"
#include "support/random_splines.h"

namespace fairing::solver {
namespace {

using namespace ::fairing::testing;  // NOLINT: random numbers

constexpr int kPoints = 9;

TieRow randomTie(Random& random, const std::vector<int>& points) {
  TieRow row{points, {}, randomVector(random)};
  for (std::size_t k = 0; k < points.size(); ++k)
    row.weights.push_back(randomNumber(random, 0.5, 1.5));
  return row;
}

// Points 0 and 8 fixed; a block for 1 and 2, and one for 4 that leans on 2. Any positive energy.
QuadraticProgram someProgram() {
  Random random{0};
  QuadraticProgram program;
  const Eigen::MatrixXd root = randomMatrix(random, kPoints, kPoints);
  const Eigen::MatrixXd energy =
      root * root.transpose() + Eigen::MatrixXd::Identity(kPoints, kPoints);
  program.stiffness = energy.sparseView();
  program.fixed.assign(kPoints, 0);
  program.fixed[0] = program.fixed[8] = 1;
  program.values = randomMatrix(random, kPoints, 3);
  program.ties = {{{randomTie(random, {0, 1, 2, 3}), randomTie(random, {1, 2, 5})}, {1, 2}},
                  {{randomTie(random, {2, 4, 6, 8})}, {4}}};
  return program;
}

double residual(const TieRow& row, const Points& x) {
  Eigen::Vector3d sum = -row.right;
  for (std::size_t k = 0; k < row.points.size(); ++k)
    sum += row.weights[k] * x.row(row.points[k]).transpose();
  return sum.norm();
}

double worstOf(const QuadraticProgram& program, const Points& x) {
  double worst = 0.0;
  for (const TieBlock& block : program.ties)
    for (const TieRow& row : block.rows) worst = std::max(worst, residual(row, x));
  return worst;
}

TEST(TiePoints, EveryChoiceOfTheFreePointsMeetsEveryTie) {
  const QuadraticProgram program = someProgram();
  const TiedPoints tied = tiePoints(program);
  Random random{1};
  for (int k = 0; k < 10; ++k) {
    Points z = randomMatrix(random, tied.basis.cols(), 3);
    for (std::size_t m = 0; m < tied.free.size(); ++m)
      if (program.fixed[static_cast<std::size_t>(tied.free[m])])
        z.row(static_cast<Eigen::Index>(m)) = program.values.row(tied.free[m]);
    const Points x = tied.basis * z + tied.offset;
    EXPECT_LT(worstOf(program, x), 1e-12);
    for (std::size_t m = 0; m < tied.free.size(); ++m)
      EXPECT_LT((x.row(tied.free[m]) - z.row(static_cast<Eigen::Index>(m))).norm(), 1e-14);
  }
}

TEST(TiePoints, DropsDependentRows) {
  QuadraticProgram program = someProgram();
  const std::size_t free = tiePoints(program).free.size();
  TieRow sum = program.ties[0].rows[0];
  for (double& weight : sum.weights) weight *= 2.0;
  sum.right *= 2.0;
  program.ties[0].rows.push_back(sum);
  const TiedPoints tied = tiePoints(program);
  EXPECT_EQ(tied.free.size(), free);
  EXPECT_LT(tied.residual, 1e-12);
}

TEST(TiePoints, TellsOfTiesThatContradictEachOther) {
  QuadraticProgram program = someProgram();
  TieRow other = program.ties[1].rows[0];
  other.right.x() += 0.5;
  program.ties[1].rows.push_back(other);
  EXPECT_GT(tiePoints(program).residual, 0.1);
}

TEST(TiePoints, TheMinimiserHasTheLeastEnergyOfAllThatMeetTheTies) {
  const QuadraticProgram program = someProgram();
  const auto solution = solve(program);
  ASSERT_TRUE(solution.has_value());
  EXPECT_LT(worstOf(program, solution->points), 1e-12);
  const double least = energy(program.stiffness, solution->points);
  const Sparse freedom = freedomOf(program);
  Random random{2};
  for (int k = 0; k < 20; ++k) {
    const Eigen::VectorXd move = freedom * randomMatrix(random, freedom.cols(), 1);
    Points x = solution->points;
    for (int i = 0; i < kPoints; ++i) x.row(i) += 0.1 * move.segment<3>(3 * i).transpose();
    EXPECT_LT(worstOf(program, x), 1e-11);
    EXPECT_GT(energy(program.stiffness, x), least);
  }
}

TEST(TiePoints, TheProgramWithoutTiesHasTheSameEnergyUpToAConstant) {
  const QuadraticProgram program = someProgram();
  const TiedPoints tied = tiePoints(program);
  const QuadraticProgram bare = withoutTies(program, tied);
  EXPECT_TRUE(bare.ties.empty());
  const auto reduced = solve(bare), whole = solve(program);
  ASSERT_TRUE(reduced.has_value() && whole.has_value());
  const Points x = tied.basis * reduced->points + tied.offset;
  EXPECT_LT((x - whole->points).norm(), 1e-10);
}

}  // namespace
}  // namespace fairing::solver
