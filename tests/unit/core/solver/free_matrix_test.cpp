// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/free_matrix.h"

#include <gmock/gmock.h>

#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::solver {
namespace {

using namespace ::fairing::testing;  // NOLINT: matchers, random numbers
using Eigen::MatrixXd;

constexpr int kPoints = 7, kFree = 13;
const std::vector<std::vector<int>> kElements{{0, 1, 2, 3}, {3, 2, 5}, {4, 5, 6, 0}};

// Some coordinates are free, some follow several others, some are fixed.
Sparse someFreedom(Random& random) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < kFree; ++k) entries.emplace_back(k, k, 1.0);
  for (int row = kFree; row < 3 * kPoints - 2; ++row)
    for (int k = row % 3; k < kFree; k += 4) entries.emplace_back(row, k, randomNumber(random));
  Sparse freedom(3 * kPoints, kFree);
  freedom.setFromTriplets(entries.begin(), entries.end());
  return freedom;
}

std::vector<MatrixXd> someElements(Random& random) {
  std::vector<MatrixXd> all;
  for (const auto& points : kElements) {
    const auto size = 3 * static_cast<Eigen::Index>(points.size());
    const MatrixXd half = randomMatrix(random, size, size);
    all.push_back(half + half.transpose());
  }
  return all;
}

TEST(FreeMatrix, IsTheSumOfTheElementsInTheFreeDirections) {
  Random random{0};
  const Sparse freedom = someFreedom(random);
  const std::vector<MatrixXd> elements = someElements(random);
  MatrixXd whole = MatrixXd::Zero(3 * kPoints, 3 * kPoints);
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (std::size_t a = 0; a < kElements[e].size(); ++a)
      for (std::size_t b = 0; b < kElements[e].size(); ++b)
        whole.block<3, 3>(3 * kElements[e][a], 3 * kElements[e][b]) += elements[e].block<3, 3>(
            3 * static_cast<Eigen::Index>(a), 3 * static_cast<Eigen::Index>(b));
  const MatrixXd expected = freedom.transpose() * whole * freedom;
  const MatrixXd sum = FreeMatrix(freedom, kElements).sum(elements);
  EXPECT_THAT(sum, IsNear(expected, 1e-13 * expected.cwiseAbs().maxCoeff()));
}

TEST(FreeMatrix, EverySumHasThePattern) {
  Random random{1};
  const FreeMatrix matrix(someFreedom(random), kElements);
  const Sparse sum = matrix.sum(someElements(random));
  EXPECT_EQ(sum.nonZeros(), matrix.pattern().nonZeros());
  EXPECT_LT(sum.nonZeros(), kFree * kFree);  // points 1 and 4 are in no element together
  EXPECT_EQ(matrix.pattern().norm(), 0.0);
}

}  // namespace
}  // namespace fairing::solver
