// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/condense.h"

#include <gmock/gmock.h>

#include <Eigen/Dense>

#include "support/random_splines.h"

namespace fairing::solver {
namespace {

using namespace ::fairing::testing;  // NOLINT: random numbers
using Eigen::Index;
using Eigen::MatrixXd;

// A chain of points, each coupled to its two neighbours on either side; a pair of neighbours in the
// middle is in a row, which parts the inner points, and the first point is fixed.
struct Chain {
  explicit Chain(int n) : middle(n / 2) {
    Random random{0};
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 6.0);
    for (int i = 0; i < n; ++i)
      for (int j = i + 1; j < std::min(n, i + 3); ++j) {
        const double value = randomNumber(random, -1.0, 1.0);
        entries.emplace_back(i, j, value);
        entries.emplace_back(j, i, value);
      }
    program.stiffness.resize(n, n);
    program.stiffness.setFromTriplets(entries.begin(), entries.end());
    program.load = randomMatrix(random, 3 * n, 1);
    program.fixed.assign(static_cast<std::size_t>(n), 0);
    program.fixed[0] = 1;
    program.values = randomMatrix(random, n, 3);
    program.blocks = {
        {{{{middle, middle + 1}, {randomVector(random), randomVector(random)}, 0.0}}, {middle}}};
  }
  int middle;
  QuadraticProgram program;
};

// The minimiser where the rows are left out: the first point alone is fixed.
Points minimiser(const QuadraticProgram& program) {
  const MatrixXd k = program.stiffness;
  const Index n = k.rows() - 1;
  const Points load = Eigen::Map<const Points>(program.load.data(), n + 1, 3);
  const MatrixXd right =
      load.bottomRows(n) - k.bottomLeftCorner(n, 1) * program.values.topRows<1>();
  Points all(n + 1, 3);
  all.topRows<1>() = program.values.topRows<1>();
  all.bottomRows(n) = k.bottomRightCorner(n, n).ldlt().solve(right);
  return all;
}

class CondensationOf : public ::testing::TestWithParam<int> {};

// 900: parts that are factorised as sparse ones.
INSTANTIATE_TEST_SUITE_P(Sizes, CondensationOf, ::testing::Values(12, 900));

TEST_P(CondensationOf, LeavesFixedPointsAndRows) {
  const Chain chain(GetParam());
  const Condensation condensed(chain.program);
  ASSERT_TRUE(condensed.isRegular());
  EXPECT_EQ(condensed.eliminated(), GetParam() - 3);
  EXPECT_EQ(condensed.program().fixed, (std::vector<char>{1, 0, 0}));
  const ConstraintBlock& block = condensed.program().blocks.front();
  EXPECT_EQ(block.solvedFor, std::vector<int>{1});
  EXPECT_EQ(block.rows.front().points, (std::vector<int>{1, 2}));
}

TEST_P(CondensationOf, HasTheSameMinimiser) {
  const Chain chain(GetParam());
  const Condensation condensed(chain.program);
  const Points all = condensed.expanded(minimiser(condensed.program()));
  EXPECT_LT((all - minimiser(chain.program)).norm(), 1e-10);
}

TEST(Condensation, TellsWhereTheEnergyLeavesPointsOpen) {
  Chain chain(12);
  chain.program.stiffness.setZero();
  EXPECT_FALSE(Condensation(chain.program).isRegular());
}

}  // namespace
}  // namespace fairing::solver
