// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/band_matrix.h"

#include <gtest/gtest.h>

#include <random>

namespace fairing::solver {
namespace {

// Diagonally dominant, so positive definite.
BandMatrix randomBand(int size, int width) {
  std::mt19937 generator{0};
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  BandMatrix matrix(size, width);
  for (int j = 0; j < size; ++j) {
    matrix.at(j, j) = 2.0 * width + 1.0;
    for (int i = j + 1; i <= std::min(j + width, size - 1); ++i) matrix.at(i, j) = entry(generator);
  }
  return matrix;
}

Eigen::MatrixXd dense(const BandMatrix& matrix) {
  return matrix * Eigen::MatrixXd::Identity(matrix.size(), matrix.size());
}

TEST(BandMatrix, MultipliesAsASymmetricOne) {
  const Eigen::MatrixXd matrix = dense(randomBand(30, 4));
  EXPECT_EQ(matrix, matrix.transpose());
  EXPECT_EQ(matrix(10, 15), 0.0);
  EXPECT_NE(matrix(10, 14), 0.0);
}

// Sizes below, at and beyond a block of columns; bands narrower and wider than one.
TEST(BandCholesky, SolvesAsMultiplied) {
  for (const auto& [size, width] : {std::pair(1, 0),
                                    std::pair(7, 20),
                                    std::pair(48, 5),
                                    std::pair(130, 20),
                                    std::pair(200, 97)}) {
    const BandMatrix matrix = randomBand(size, width);
    const Eigen::MatrixXd x = Eigen::MatrixXd::Random(size, 2);
    const auto factor = BandCholesky::factor(matrix);
    ASSERT_TRUE(factor);
    EXPECT_LT((factor->solve(matrix * x) - x).cwiseAbs().maxCoeff(), 1e-13) << size;
  }
}

// Bands of one tile and of several.
TEST(BandCholesky, DoesNotDependOnTheNumberOfThreads) {
  for (const int width : {20, 330}) {
    const BandMatrix matrix = randomBand(500, width);
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(500, 1);
    const Eigen::MatrixXd alone = BandCholesky::factor(matrix)->solve(right);
    for (const int threads : {2, 3, 8})
      EXPECT_EQ(BandCholesky::factor(matrix, threads)->solve(right), alone) << width;
  }
}

TEST(BandCholesky, RefusesWhatIsNotPositiveDefinite) {
  for (const int bad : {0, 60, 99}) {
    BandMatrix matrix = randomBand(100, 9);
    matrix.at(bad, bad) = -1.0;
    EXPECT_FALSE(BandCholesky::factor(std::move(matrix)));
  }
}

TEST(BandMatrix, AddsAMatrixOfPointsToEachCoordinate) {
  const BandMatrix points = randomBand(12, 2);
  BandMatrix matrix(36, 8);
  matrix.addThreefold(2.0, points);
  const Eigen::MatrixXd small = dense(points), large = dense(matrix);
  for (int i = 0; i < 36; ++i)
    for (int j = 0; j < 36; ++j)
      EXPECT_EQ(large(i, j), i % 3 == j % 3 ? 2.0 * small(i / 3, j / 3) : 0.0);
}

}  // namespace
}  // namespace fairing::solver
