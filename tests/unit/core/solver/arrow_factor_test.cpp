// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/arrow_factor.h"

#include <gmock/gmock.h>

#include <Eigen/Cholesky>

#include "support/matchers.h"

namespace fairing::solver {
namespace {

using namespace ::fairing::testing;  // NOLINT: matchers
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kBlocks = 3, kInner = 7, kBorder = 5, kCount = kBlocks * kInner + kBorder;

struct Arrow {
  MatrixXd matrix = MatrixXd::Zero(kCount, kCount);
  std::vector<char> inner;
};

// Blocks and border mixed up in their order.
Arrow arrow() {
  std::srand(5);
  std::vector<int> block;
  for (int k = 0; k < kCount; ++k) block.push_back(k % 5 == 4 ? -1 : k % kBlocks);
  Arrow arrow;
  const MatrixXd r = MatrixXd::Random(kCount, kCount);
  for (int i = 0; i < kCount; ++i)
    for (int j = 0; j < kCount; ++j)
      if (block[std::size_t(i)] < 0 || block[std::size_t(j)] < 0 ||
          block[std::size_t(i)] == block[std::size_t(j)])
        arrow.matrix(i, j) = r(i, j) + r(j, i) + (i == j ? 2.0 * kCount : 0.0);
  for (const int b : block) arrow.inner.push_back(b >= 0);
  return arrow;
}

TEST(ArrowFactor, SolvesWhatADenseFactorSolves) {
  const Arrow given = arrow();
  const Sparse matrix = given.matrix.sparseView();
  ArrowFactor factor(matrix, given.inner);
  ASSERT_TRUE(factor.factorize(matrix));
  const VectorXd right = VectorXd::LinSpaced(kCount, -1.0, 3.0);
  EXPECT_THAT(factor.solve(right), IsNear(VectorXd(given.matrix.llt().solve(right)), 1e-12));
}

TEST(ArrowFactor, TakesMatricesWithFewerEntries) {
  const Arrow given = arrow();
  ArrowFactor factor(given.matrix.sparseView(), given.inner);
  const MatrixXd diagonal = given.matrix.diagonal().asDiagonal();
  ASSERT_TRUE(factor.factorize(diagonal.sparseView()));
  const VectorXd right = VectorXd::Ones(kCount);
  EXPECT_THAT(factor.solve(right), IsNear(VectorXd(diagonal.diagonal().cwiseInverse()), 1e-14));
}

TEST(ArrowFactor, ManagesWithoutABorderAndWithoutBlocks) {
  const Arrow given = arrow();
  const Sparse matrix = given.matrix.sparseView();
  const VectorXd right = VectorXd::LinSpaced(kCount, -1.0, 3.0);
  for (const char all : {char(0), char(1)}) {
    ArrowFactor factor(matrix, std::vector<char>(kCount, all));
    ASSERT_TRUE(factor.factorize(matrix));
    EXPECT_THAT(factor.solve(right), IsNear(VectorXd(given.matrix.llt().solve(right)), 1e-12));
  }
}

TEST(ArrowFactor, RefusesWhatIsNotDefinite) {
  const Arrow given = arrow();
  const Sparse matrix = given.matrix.sparseView();
  ArrowFactor factor(matrix, given.inner);
  EXPECT_FALSE(factor.factorize(-matrix));
  Sparse onBorder = matrix;
  onBorder.coeffRef(4, 4) = -1e4;
  EXPECT_FALSE(factor.factorize(onBorder));
}

}  // namespace
}  // namespace fairing::solver
