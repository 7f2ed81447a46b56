// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/solve_bound.h"

#include <Eigen/Cholesky>
#include <array>

// Minimise 1/2 X'(K (x) I3)X - f'X over X = x0 + T y:  (T'(K (x) I3)T) y = T'(f - K x0).
// [NocedalWright2006] section 16.2

namespace fairing::solver {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The rows of T of each coordinate: n x m. Sparse, since a free unknown moves the points of its own
// side alone.
using CoordinateBasis = std::array<Sparse, 3>;

CoordinateBasis coordinateBasis(const Sparse& basis) {
  std::array<std::vector<Eigen::Triplet<double>>, 3> entries;
  for (int j = 0; j < basis.outerSize(); ++j)
    for (Sparse::InnerIterator it(basis, j); it; ++it)
      entries[static_cast<std::size_t>(it.row() % 3)].emplace_back(
          static_cast<int>(it.row() / 3), j, it.value());
  CoordinateBasis result;
  for (std::size_t c = 0; c < 3; ++c) {
    result[c].resize(basis.rows() / 3, basis.cols());
    result[c].setFromTriplets(entries[c].begin(), entries[c].end());
  }
  return result;
}

// T'(K (x) I3)T without forming the Kronecker product: one product a coordinate.
MatrixXd projected(const MatrixXd& stiffness, const CoordinateBasis& basis) {
  MatrixXd result = MatrixXd::Zero(basis[0].cols(), basis[0].cols());
  for (const Sparse& rows : basis) {
    const MatrixXd reached = stiffness * rows;
    result += rows.transpose() * reached;
  }
  return result;
}

}  // namespace

Result<Points> solveBound(const QuadraticProgram& program, const AffineSpace& space) {
  Points points = Eigen::Map<const Points>(space.offset.data(), space.offset.size() / 3, 3);
  if (space.basis.cols() == 0) return points;
  Points right = -(program.stiffness * points);
  if (program.load.size() > 0)
    right += Eigen::Map<const Points>(program.load.data(), points.rows(), 3);
  const CoordinateBasis basis = coordinateBasis(space.basis);
  const Eigen::LLT<MatrixXd> factor(projected(MatrixXd(program.stiffness), basis));
  if (factor.info() != Eigen::Success) return fail({ErrorCode::SystemSingular});
  VectorXd pull = VectorXd::Zero(space.basis.cols());
  for (Index c = 0; c < 3; ++c)
    pull += basis[static_cast<std::size_t>(c)].transpose() * right.col(c);
  const VectorXd free = factor.solve(pull);
  for (Index c = 0; c < 3; ++c) points.col(c) += basis[static_cast<std::size_t>(c)] * free;
  return points;
}

}  // namespace fairing::solver
