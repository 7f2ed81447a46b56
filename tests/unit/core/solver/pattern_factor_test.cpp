// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/pattern_factor.h"

#include <gmock/gmock.h>

#include <Eigen/Cholesky>

#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::solver {
namespace {

using namespace ::fairing::testing;  // NOLINT: matchers, random numbers
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Entries up to `band` beside the diagonal, positive definite.
Sparse banded(int count, int band) {
  Random random{0};
  MatrixXd matrix = MatrixXd::Zero(count, count);
  for (int i = 0; i < count; ++i)
    for (int j = std::max(0, i - band); j <= i; ++j)
      matrix(i, j) = matrix(j, i) = i == j ? 2.0 * band + 1.0 : randomNumber(random);
  return matrix.sparseView();
}

Sparse identity(int count) {
  Sparse matrix(count, count);
  matrix.setIdentity();
  return matrix;
}

// A narrow band is left to the sparse factorisation, a full matrix to dense blocks.
class PatternFactorOfABand : public ::testing::TestWithParam<int> {};

TEST_P(PatternFactorOfABand, SolvesWhatADenseFactorSolves) {
  constexpr int kCount = 60;
  const Sparse matrix = banded(kCount, GetParam());
  PatternFactor factor(matrix, identity(kCount));
  const VectorXd right = VectorXd::LinSpaced(kCount, -1.0, 3.0);
  for (const double scale : {1.0, 3.0}) {  // the analysis is kept
    ASSERT_TRUE(factor.factorize(scale * matrix));
    const VectorXd expected = MatrixXd(scale * matrix).llt().solve(right);
    EXPECT_THAT(factor.solve(right), IsNear(expected, 1e-12));
  }
}

TEST_P(PatternFactorOfABand, RefusesWhatIsNotPositiveDefinite) {
  constexpr int kCount = 60;
  Sparse matrix = banded(kCount, GetParam());
  PatternFactor factor(matrix, identity(kCount));
  matrix.coeffRef(20, 20) = -1.0;
  EXPECT_FALSE(factor.factorize(matrix));
}

INSTANTIATE_TEST_SUITE_P(NarrowAndFull, PatternFactorOfABand, ::testing::Values(2, 59));

}  // namespace
}  // namespace fairing::solver
