// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/tie_points.h"

#include <algorithm>
#include <map>

#include "core/base/assert.h"
#include "core/solver/block_elimination.h"

namespace fairing::solver {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

// Rows smaller than this beside the largest are taken for dependent. Weights are of the order of 1.
constexpr double kRankThreshold = 1e-9;

// Unknown p is point p, its coordinates the three columns.
using Elimination = BlockElimination<3>;

void solveBlock(const TieBlock& block, Elimination& elimination) {
  std::vector<EliminationRow<3>> rows;
  for (const TieRow& row : block.rows) {
    EliminationRow<3> entry;
    entry.right = row.right.transpose();
    for (std::size_t k = 0; k < row.points.size(); ++k)
      entry.entries.emplace_back(row.points[k], row.weights[k]);
    rows.push_back(std::move(entry));
  }
  elimination.solve(rows, block.solvedFor);
}

using SparseByRow = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// A row of the blocks in the free points.
LinearRow inFreePoints(const LinearRow& row, const TiedPoints& tied, const SparseByRow& basis) {
  LinearRow result;
  result.right = row.right;
  std::map<int, Vector3d> weights;
  for (std::size_t k = 0; k < row.points.size(); ++k) {
    result.right -= row.weights[k].dot(tied.offset.row(row.points[k]));
    for (SparseByRow::InnerIterator it(basis, row.points[k]); it; ++it)
      weights.try_emplace(static_cast<int>(it.col()), Vector3d::Zero()).first->second +=
          it.value() * row.weights[k];
  }
  for (const auto& [point, weight] : weights) {
    result.points.push_back(point);
    result.weights.push_back(weight);
  }
  return result;
}

}  // namespace

TiedPoints tiePoints(const QuadraticProgram& program) {
  Elimination elimination(program.fixed.size(), kRankThreshold);
  for (std::size_t p = 0; p < program.fixed.size(); ++p)
    if (program.fixed[p])
      elimination.fix(static_cast<int>(p), program.values.row(static_cast<Index>(p)));
  for (const TieBlock& block : program.ties) solveBlock(block, elimination);
  const auto& all = elimination.finish();
  TiedPoints tied;
  tied.residual = elimination.residual();
  std::vector<int> column(all.size(), -1);
  for (std::size_t p = 0; p < all.size(); ++p)
    if (all[p].free || program.fixed[p]) {  // a fixed point stays one, in its own column
      column[p] = static_cast<int>(tied.free.size());
      tied.free.push_back(static_cast<int>(p));
    }
  std::vector<Eigen::Triplet<double>> entries;
  tied.offset = Points::Zero(static_cast<Index>(all.size()), 3);
  for (std::size_t p = 0; p < all.size(); ++p) {
    const int row = static_cast<int>(p);
    if (column[p] >= 0) {
      entries.emplace_back(row, column[p], 1.0);
      continue;
    }
    tied.offset.row(row) = all[p].constant;
    for (const auto& [point, factor] : all[p].terms) {
      FAIRING_ASSERT(column[static_cast<std::size_t>(point)] >= 0);
      entries.emplace_back(row, column[static_cast<std::size_t>(point)], factor);
    }
  }
  tied.basis.resize(static_cast<Index>(all.size()), static_cast<Index>(tied.free.size()));
  tied.basis.setFromTriplets(entries.begin(), entries.end());
  return tied;
}

QuadraticProgram withoutTies(const QuadraticProgram& program, const TiedPoints& tied) {
  const Sparse& basis = tied.basis;
  QuadraticProgram reduced;
  const Sparse across = basis.transpose();  // twice as fast as a product with the expression
  reduced.stiffness = across * Sparse(program.stiffness * basis);
  const auto n = static_cast<Index>(program.fixed.size());
  Points load = -(program.stiffness * tied.offset);
  if (program.load.size() > 0) load += Eigen::Map<const Points>(program.load.data(), n, 3);
  const Points free = basis.transpose() * load;
  reduced.load = Eigen::Map<const Eigen::VectorXd>(free.data(), free.size());
  reduced.values.resize(static_cast<Index>(tied.free.size()), 3);
  std::vector<int> place(program.fixed.size(), -1);
  for (std::size_t k = 0; k < tied.free.size(); ++k) {
    const int point = tied.free[k];
    place[static_cast<std::size_t>(point)] = static_cast<int>(k);
    reduced.fixed.push_back(program.fixed[static_cast<std::size_t>(point)]);
    reduced.values.row(static_cast<Index>(k)) = program.values.row(point);
  }
  const SparseByRow byRow(basis);
  for (const ConstraintBlock& block : program.blocks) {
    ConstraintBlock own;
    for (const LinearRow& row : block.rows) own.rows.push_back(inFreePoints(row, tied, byRow));
    for (const int point : block.solvedFor)
      for (SparseByRow::InnerIterator it(byRow, point); it; ++it)
        own.solvedFor.push_back(static_cast<int>(it.col()));
    std::sort(own.solvedFor.begin(), own.solvedFor.end());
    own.solvedFor.erase(std::unique(own.solvedFor.begin(), own.solvedFor.end()),
                        own.solvedFor.end());
    reduced.blocks.push_back(std::move(own));
  }
  return reduced;
}

}  // namespace fairing::solver
