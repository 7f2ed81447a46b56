// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/quadratic_program.h"

namespace fairing::solver {

Eigen::VectorXd flat(const Points& points) {
  return Eigen::Map<const Eigen::VectorXd>(points.data(), points.size());
}

Sparse threefold(const Sparse& matrix) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * static_cast<std::size_t>(matrix.nonZeros()));
  for (int j = 0; j < matrix.outerSize(); ++j)
    for (Sparse::InnerIterator it(matrix, j); it; ++it)
      for (int c = 0; c < 3; ++c)
        entries.emplace_back(3 * static_cast<int>(it.row()) + c, 3 * j + c, it.value());
  Sparse result(3 * matrix.rows(), 3 * matrix.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace fairing::solver
