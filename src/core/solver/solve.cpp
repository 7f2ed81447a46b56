// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/solve.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "core/solver/eliminate_constraints.h"

// Minimise 1/2 X'KX - f'X over X = x0 + T y:   (T'KT) y = T'(f - K x0).   [NocedalWright2006]
// section 16.2
//   K = stiffness (x) I3 + coupled,  x0 = offset,  T = basis.
// Where nothing couples the coordinates, the points no constraint touches (most of a patch) are
// eliminated first with one factorisation for the three coordinates; what remains is dense and as
// small as the border:
//   S = K_bb - K_bi K_ii^-1 K_ib,   i inner, b bound by a constraint.

namespace fairing::solver {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Partition {
  std::vector<int> inner, bound;  // point numbers; fixed points are in neither
  std::vector<int> place;         // position in its list, -1 for fixed
};

Partition partition(const QuadraticProgram& program, const AffineSpace& space) {
  Partition parts;
  for (std::size_t p = 0; p < program.fixed.size(); ++p) {
    if (program.fixed[p]) {
      parts.place.push_back(-1);
      continue;
    }
    std::vector<int>& list = space.bound[p] ? parts.bound : parts.inner;
    parts.place.push_back(static_cast<int>(list.size()));
    list.push_back(static_cast<int>(p));
  }
  return parts;
}

// K_ii and K_ib, K_bb of the scalar stiffness, and the right side f - K x over the fixed points.
struct Blocks {
  MatrixXd ii, ib, bb;
  Points rightInner, rightBound;
};

Blocks gather(const QuadraticProgram& program, const Partition& parts) {
  const auto ni = static_cast<Index>(parts.inner.size()),
             nb = static_cast<Index>(parts.bound.size());
  Blocks k{MatrixXd::Zero(ni, ni),
           MatrixXd::Zero(ni, nb),
           MatrixXd::Zero(nb, nb),
           Points::Zero(ni, 3),
           Points::Zero(nb, 3)};
  const auto isInner = [&](std::size_t p) {
    return !program.fixed[p] && parts.place[p] >= 0 &&
           static_cast<std::size_t>(parts.place[p]) < parts.inner.size() &&
           parts.inner[static_cast<std::size_t>(parts.place[p])] == static_cast<int>(p);
  };
  for (int j = 0; j < program.stiffness.outerSize(); ++j)
    for (Sparse::InnerIterator it(program.stiffness, j); it; ++it) {
      const auto row = static_cast<std::size_t>(it.row()), col = static_cast<std::size_t>(j);
      if (program.fixed[row]) continue;
      const bool rowInner = isInner(row);
      if (program.fixed[col]) {
        Points& right = rowInner ? k.rightInner : k.rightBound;
        right.row(parts.place[row]) -= it.value() * program.values.row(j);
        continue;
      }
      const bool colInner = isInner(col);
      if (rowInner && colInner)
        k.ii(parts.place[row], parts.place[col]) = it.value();
      else if (rowInner)
        k.ib(parts.place[row], parts.place[col]) = it.value();
      else if (!colInner)
        k.bb(parts.place[row], parts.place[col]) = it.value();
    }
  if (program.load.size() > 0)
    for (std::size_t p = 0; p < program.fixed.size(); ++p) {
      if (program.fixed[p]) continue;
      Points& right = isInner(p) ? k.rightInner : k.rightBound;
      right.row(parts.place[p]) += program.load.segment<3>(3 * static_cast<Index>(p)).transpose();
    }
  return k;
}

// The rows of the bound points of the affine space: 3 nb x m dense, m the free coordinates of bound
// points.
MatrixXd boundBasis(const AffineSpace& space, const Partition& parts) {
  std::vector<Index> columns;
  MatrixXd dense = MatrixXd::Zero(3 * static_cast<Index>(parts.bound.size()), 0);
  std::vector<Index> columnOf(static_cast<std::size_t>(space.basis.cols()), -1);
  const Eigen::SparseMatrix<double, Eigen::RowMajor> rows = space.basis;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t b = 0; b < parts.bound.size(); ++b)
    for (int c = 0; c < 3; ++c)
      for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(rows,
                                                                          3 * parts.bound[b] + c);
           it;
           ++it) {
        Index& column = columnOf[static_cast<std::size_t>(it.col())];
        if (column < 0) {
          column = static_cast<Index>(columns.size());
          columns.push_back(it.col());
        }
        entries.emplace_back(3 * static_cast<int>(b) + c, static_cast<int>(column), it.value());
      }
  dense.setZero(3 * static_cast<Index>(parts.bound.size()), static_cast<Index>(columns.size()));
  for (const auto& e : entries) dense(e.row(), e.col()) = e.value();
  return dense;
}

// T'(S (x) I3)T without forming the Kronecker product: one product a coordinate.
MatrixXd projected(const MatrixXd& schur, const MatrixXd& basis) {
  MatrixXd result = MatrixXd::Zero(basis.cols(), basis.cols());
  for (Index c = 0; c < 3; ++c) {
    const MatrixXd rows = basis(Eigen::seq(c, basis.rows() - 1, 3), Eigen::all);
    result.noalias() += rows.transpose() * (schur * rows);
  }
  return result;
}

Result<Solution> solveUncoupled(const QuadraticProgram& program, const AffineSpace& space) {
  const Partition parts = partition(program, space);
  const Blocks k = gather(program, parts);
  const Eigen::LLT<MatrixXd> inner(k.ii);
  if (k.ii.rows() > 0 && inner.info() != Eigen::Success) return fail({ErrorCode::SystemSingular});
  Solution solution;
  solution.points = program.values;
  const auto nb = static_cast<Index>(parts.bound.size());
  Points boundPoints(nb, 3);
  if (nb > 0) {
    const MatrixXd reach = inner.solve(k.ib);
    const MatrixXd schur = k.bb - k.ib.transpose() * reach;
    Points right = k.rightBound - reach.transpose() * k.rightInner;
    Points offset(nb, 3);
    for (Index b = 0; b < nb; ++b)
      offset.row(b) =
          space.offset.segment<3>(3 * parts.bound[static_cast<std::size_t>(b)]).transpose();
    right -= schur * offset;
    const MatrixXd basis = boundBasis(space, parts);
    const Eigen::Map<const VectorXd> flat(right.data(), right.size());
    const Eigen::LLT<MatrixXd> outer(projected(schur, basis));
    if (basis.cols() > 0 && outer.info() != Eigen::Success)
      return fail({ErrorCode::SystemSingular});
    const VectorXd y = outer.solve(basis.transpose() * flat);
    const VectorXd moved = basis * y;
    boundPoints = offset + Eigen::Map<const Points>(moved.data(), nb, 3);
  }
  const Points innerPoints = inner.solve(k.rightInner - k.ib * boundPoints);
  for (std::size_t b = 0; b < parts.bound.size(); ++b)
    solution.points.row(parts.bound[b]) = boundPoints.row(static_cast<Index>(b));
  for (std::size_t i = 0; i < parts.inner.size(); ++i)
    solution.points.row(parts.inner[i]) = innerPoints.row(static_cast<Index>(i));
  return solution;
}

// K = stiffness (x) I3 + coupled.
Sparse fullStiffness(const QuadraticProgram& program) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < program.stiffness.outerSize(); ++j)
    for (Sparse::InnerIterator it(program.stiffness, j); it; ++it)
      for (int c = 0; c < 3; ++c)
        entries.emplace_back(3 * static_cast<int>(it.row()) + c, 3 * j + c, it.value());
  const Index n = 3 * program.stiffness.rows();
  Sparse full(n, n);
  full.setFromTriplets(entries.begin(), entries.end());
  if (program.coupled.rows() == n) full += program.coupled;
  return full;
}

Result<Solution> solveCoupled(const QuadraticProgram& program, const AffineSpace& space) {
  const Sparse stiffness = fullStiffness(program);
  const Sparse reduced = space.basis.transpose() * stiffness * space.basis;
  VectorXd right = -(stiffness * space.offset);
  if (program.load.size() > 0) right += program.load;
  const Eigen::SimplicialLDLT<Sparse> factor(reduced);
  if (factor.info() != Eigen::Success) return fail({ErrorCode::SystemSingular});
  const VectorXd x = space.offset + space.basis * factor.solve(space.basis.transpose() * right);
  Solution solution;
  solution.points = Eigen::Map<const Points>(x.data(), x.size() / 3, 3);
  return solution;
}

}  // namespace

Result<Solution> solve(const QuadraticProgram& program) {
  const AffineSpace space = eliminateConstraints(program);
  const bool coupled = program.coupled.nonZeros() > 0;
  Result<Solution> solution =
      coupled ? solveCoupled(program, space) : solveUncoupled(program, space);
  if (!solution) return solution;
  if (!solution->points.allFinite()) return fail({ErrorCode::NotFinite});
  solution->unknowns = static_cast<int>(space.basis.cols());
  solution->constraints = space.rows;
  solution->residual = space.residual;
  return solution;
}

}  // namespace fairing::solver
