// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace fairing::solver {

using Sparse = Eigen::SparseMatrix<double>;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// sum_k weights[k] . point(points[k]) = right, with vector weights.
struct LinearRow {
  std::vector<int> points;
  std::vector<Eigen::Vector3d> weights;
  double right = 0.0;
};

/// sum_k weights[k] * point(points[k]) = right, the same for the three coordinates.
struct TieRow {
  std::vector<int> points;
  std::vector<double> weights;
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
};

/// Ties that are solved for some of their points, the rest being handed through. Later blocks see
/// what earlier ones have found.
struct TieBlock {
  std::vector<TieRow> rows;
  std::vector<int> solvedFor;
};

/// Rows that are solved for the coordinates of some points of their own, the rest of the points
/// being handed through. Later blocks see what earlier ones have found.
struct ConstraintBlock {
  std::vector<LinearRow> rows;
  std::vector<int> solvedFor;
};

/// Minimises over n points x_i in space
///   1/2 sum_ij stiffness_ij x_i . x_j + 1/2 X' coupled X - load . X      X = (x_0, y_0, z_0, x_1,
///   ...)
/// subject to x_i = values_i where fixed, to the ties, and to the rows of the blocks, in this
/// order.
struct QuadraticProgram {
  Sparse stiffness;         ///< n x n, symmetric: the same for the three coordinates
  Sparse coupled;           ///< 3n x 3n, symmetric, or empty: what couples the coordinates
  Eigen::VectorXd load;     ///< 3n, or empty
  std::vector<char> fixed;  ///< n flags
  Points values;            ///< n x 3, read where fixed
  std::vector<TieBlock> ties;
  std::vector<ConstraintBlock> blocks;
};

/// The coordinates of points: x_0, y_0, z_0, x_1, ...
[[nodiscard]] Eigen::VectorXd flat(const Points& points);

/// A matrix of points as one of coordinates: M (x) I3.
[[nodiscard]] Sparse threefold(const Sparse& matrix);

}  // namespace fairing::solver
