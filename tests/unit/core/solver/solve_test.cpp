// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/solve.h"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <numeric>

#include "support/matchers.h"
#include "support/quadratic_forms.h"
#include "support/random_splines.h"

namespace fairing::solver {
namespace {

using namespace ::fairing::testing;  // NOLINT: random numbers and quadratic forms
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kPoints = 12;

MatrixXd definite(Random& random, Index size) {
  const MatrixXd a = randomMatrix(random, size, size);
  return a * a.transpose() + 0.1 * MatrixXd::Identity(size, size);
}

LinearRow randomRow(Random& random, const std::vector<int>& points) {
  LinearRow row;
  row.points = points;
  for (std::size_t k = 0; k < points.size(); ++k) row.weights.push_back(randomVector(random));
  row.right = randomNumber(random);
  return row;
}

// Two fixed points; a block that solves for 2 and 3; one that uses 2 and 6, and solves for 4 and 5.
QuadraticProgram randomProgram(unsigned seed, bool coupled) {
  Random random{seed};
  QuadraticProgram program;
  program.stiffness = definite(random, kPoints).sparseView();
  if (coupled) program.coupled = definite(random, 3 * kPoints).sparseView();
  program.load = randomMatrix(random, 3 * kPoints, 1);
  program.fixed.assign(kPoints, 0);
  program.fixed[0] = program.fixed[1] = 1;
  program.values = randomMatrix(random, kPoints, 3);
  const LinearRow a = randomRow(random, {0, 2, 3}), b = randomRow(random, {2, 3});
  const LinearRow c = randomRow(random, {2, 4, 5}), e = randomRow(random, {4, 5, 6}),
                  f = randomRow(random, {1, 5, 6});
  program.blocks = {{{a, b}, {2, 3}}, {{c, e, f}, {4, 5}}};
  return program;
}

MatrixXd denseStiffness(const QuadraticProgram& program) {
  const Index n = program.stiffness.rows();
  const MatrixXd scalar = program.stiffness;
  MatrixXd full = MatrixXd::Zero(3 * n, 3 * n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      full.block<3, 3>(3 * i, 3 * j) = scalar(i, j) * Eigen::Matrix3d::Identity();
  if (program.coupled.rows() > 0) full += MatrixXd(program.coupled);
  return full;
}

double objective(const QuadraticProgram& program, const VectorXd& x) {
  const double load = program.load.size() > 0 ? program.load.dot(x) : 0.0;
  return 0.5 * x.dot(denseStiffness(program) * x) - load;
}

// Every constraint, fixed points too, as one dense system C x = d.
struct DenseRows {
  MatrixXd c;
  VectorXd d;
};

DenseRows denseRows(const QuadraticProgram& program) {
  std::vector<std::pair<VectorXd, double>> rows;
  const Index size = 3 * program.stiffness.rows();
  for (std::size_t p = 0; p < program.fixed.size(); ++p)
    for (Index k = 0; program.fixed[p] && k < 3; ++k) {
      const auto at = static_cast<Index>(p);
      rows.emplace_back(VectorXd::Unit(size, 3 * at + k), program.values(at, k));
    }
  for (const ConstraintBlock& block : program.blocks)
    for (const LinearRow& row : block.rows) {
      VectorXd c = VectorXd::Zero(size);
      for (std::size_t k = 0; k < row.points.size(); ++k)
        c.segment<3>(3 * row.points[k]) += row.weights[k];
      rows.emplace_back(c, row.right);
    }
  DenseRows all{MatrixXd(rows.size(), size), VectorXd(rows.size())};
  for (std::size_t r = 0; r < rows.size(); ++r) {
    all.c.row(static_cast<Index>(r)) = rows[r].first.transpose();
    all.d[static_cast<Index>(r)] = rows[r].second;
  }
  return all;
}

// [NocedalWright2006] eq. 16.4: the minimiser by the whole KKT system.
VectorXd kktSolution(const QuadraticProgram& program) {
  const DenseRows rows = denseRows(program);
  const Index n = rows.c.cols(), m = rows.c.rows();
  MatrixXd kkt = MatrixXd::Zero(n + m, n + m);
  kkt << denseStiffness(program), rows.c.transpose(), rows.c, MatrixXd::Zero(m, m);
  VectorXd right(n + m);
  right << (program.load.size() > 0 ? program.load : VectorXd::Zero(n)), rows.d;
  return kkt.fullPivLu().solve(right).head(n);
}

// Condition numbers of these problems are below 1e5.
constexpr double kRounding = 1e-9;

Points solved(const QuadraticProgram& program) {
  const auto solution = solve(program);
  EXPECT_TRUE(solution.has_value());
  return solution ? solution->points : Points();
}

class Solve : public ::testing::TestWithParam<bool> {};

TEST_P(Solve, IsTheSolutionOfTheDenseKktSystem) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const QuadraticProgram program = randomProgram(seed, GetParam());
    EXPECT_THAT(flattened(solved(program)), IsNear(kktSolution(program), kRounding))
        << "seed " << seed;
  }
}

TEST_P(Solve, MeetsEveryConstraint) {
  const QuadraticProgram program = randomProgram(3, GetParam());
  const DenseRows rows = denseRows(program);
  EXPECT_THAT(VectorXd(rows.c * flattened(solved(program))), IsNear(rows.d, 1e-12));
}

TEST_P(Solve, NoFeasiblePerturbationHasLessEnergy) {
  const QuadraticProgram program = randomProgram(4, GetParam());
  const VectorXd x = flattened(solved(program));
  const MatrixXd kernel = denseRows(program).c.fullPivLu().kernel();
  Random random{0};
  for (int k = 0; k < 50; ++k) {
    const VectorXd step = kernel * randomMatrix(random, kernel.cols(), 1);
    EXPECT_GE(objective(program, x + 1e-2 * step), objective(program, x));
  }
}

TEST_P(Solve, OrderOfThePointsIsIrrelevant) {
  const QuadraticProgram program = randomProgram(5, GetParam());
  std::vector<int> place(kPoints);  // point p becomes place[p]
  std::iota(place.begin(), place.end(), 0);
  Random random{1};
  std::shuffle(place.begin(), place.end(), random);
  QuadraticProgram shuffled = program;
  const MatrixXd stiffness = program.stiffness, coupled = program.coupled;
  MatrixXd s(kPoints, kPoints), c = MatrixXd::Zero(coupled.rows(), coupled.cols());
  for (int p = 0; p < kPoints; ++p) {
    const int to = place[static_cast<std::size_t>(p)];
    shuffled.fixed[static_cast<std::size_t>(to)] = program.fixed[static_cast<std::size_t>(p)];
    shuffled.values.row(to) = program.values.row(p);
    shuffled.load.segment<3>(3 * to) = program.load.segment<3>(3 * p);
    for (int q = 0; q < kPoints; ++q) {
      const int other = place[static_cast<std::size_t>(q)];
      s(to, other) = stiffness(p, q);
      if (coupled.rows() > 0) c.block<3, 3>(3 * to, 3 * other) = coupled.block<3, 3>(3 * p, 3 * q);
    }
  }
  shuffled.stiffness = s.sparseView();
  if (coupled.rows() > 0) shuffled.coupled = c.sparseView();
  for (ConstraintBlock& block : shuffled.blocks) {
    for (int& p : block.solvedFor) p = place[static_cast<std::size_t>(p)];
    for (LinearRow& row : block.rows)
      for (int& p : row.points) p = place[static_cast<std::size_t>(p)];
  }
  const Points before = solved(program), after = solved(shuffled);
  for (int p = 0; p < kPoints; ++p)
    EXPECT_THAT(after.row(place[static_cast<std::size_t>(p)]), IsNear(before.row(p), kRounding));
}

TEST_P(Solve, DependentRowsThatAgreeAreDropped) {
  const QuadraticProgram program = randomProgram(6, GetParam());
  QuadraticProgram doubled = program;
  LinearRow again = doubled.blocks[1].rows[0];
  for (Vector3d& w : again.weights) w *= 2.0;
  again.right *= 2.0;
  doubled.blocks[1].rows.push_back(again);
  const auto once = solve(program), twice = solve(doubled);
  ASSERT_TRUE(once && twice);
  EXPECT_EQ(twice->constraints, once->constraints);
  EXPECT_LT(twice->residual, 1e-12);
  EXPECT_THAT(twice->points, IsNear(once->points, kRounding));
}

TEST_P(Solve, RowsThatContradictEachOtherAreReported) {
  QuadraticProgram program = randomProgram(7, GetParam());
  LinearRow other = program.blocks[0].rows[0];
  other.right += 0.3;
  program.blocks[0].rows.push_back(other);
  const auto solution = solve(program);
  ASSERT_TRUE(solution.has_value());
  // Two equal rows that differ by 0.3: the least squares of both leaves 0.3 / sqrt 2.
  EXPECT_NEAR(solution->residual, 0.3 / std::sqrt(2.0), 1e-10);
}

TEST_P(Solve, CountsUnknownsAndConstraints) {
  const auto solution = solve(randomProgram(8, GetParam()));
  ASSERT_TRUE(solution.has_value());
  EXPECT_EQ(solution->constraints, 5);
  EXPECT_EQ(solution->unknowns, 3 * (kPoints - 2) - 5);
}

TEST_P(Solve, LoadThatIsNotANumberIsReported) {
  QuadraticProgram program = randomProgram(9, GetParam());
  program.load[20] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(solve(program), FailsWith(ErrorCode::NotFinite));
}

INSTANTIATE_TEST_SUITE_P(Paths, Solve, ::testing::Bool(), [](const auto& instance) {
  return instance.param ? "Coupled" : "Uncoupled";
});

TEST(SolvePaths, AgreeWhereTheCouplingIsNone) {
  const QuadraticProgram uncoupled = randomProgram(10, false);
  QuadraticProgram coupled = uncoupled;
  // Half of the stiffness moved into the coupled matrix.
  coupled.stiffness = 0.5 * uncoupled.stiffness;
  QuadraticProgram half = uncoupled;
  half.stiffness = 0.5 * uncoupled.stiffness;
  coupled.coupled = denseStiffness(half).sparseView();
  EXPECT_THAT(solved(coupled), IsNear(solved(uncoupled), kRounding));
}

TEST(SolvePaths, WithEverythingFixedTheValuesComeBack) {
  QuadraticProgram program = randomProgram(11, false);
  program.fixed.assign(kPoints, 1);
  program.blocks.clear();
  EXPECT_THAT(solved(program), IsNear(program.values, 0.0));
}

TEST(SolvePaths, AnEnergyThatDoesNotHoldThePointsIsSingular) {
  QuadraticProgram program = randomProgram(12, false);
  program.stiffness.setZero();
  EXPECT_THAT(solve(program), FailsWith(ErrorCode::SystemSingular));
}

}  // namespace
}  // namespace fairing::solver
