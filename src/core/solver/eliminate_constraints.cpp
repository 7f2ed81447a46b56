// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/eliminate_constraints.h"

#include "core/base/assert.h"
#include "core/solver/block_elimination.h"

namespace fairing::solver {
namespace {

using Eigen::Index;

// Rows smaller than this beside the largest are taken for dependent. Weights are basis values times
// unit vectors.
constexpr double kRankThreshold = 1e-10;

// Unknown 3 p + c is coordinate c of point p.
using Elimination = BlockElimination<1>;

void fixPoints(const QuadraticProgram& program, Elimination& elimination) {
  for (std::size_t p = 0; p < program.fixed.size(); ++p)
    for (int c = 0; program.fixed[p] && c < 3; ++c)
      elimination.fix(3 * static_cast<int>(p) + c,
                      Elimination::Value(program.values(static_cast<Index>(p), c)));
}

void solveBlock(const ConstraintBlock& block, Elimination& elimination) {
  std::vector<EliminationRow<1>> rows;
  for (const LinearRow& row : block.rows) {
    EliminationRow<1> scalar;
    scalar.right[0] = row.right;
    for (std::size_t k = 0; k < row.points.size(); ++k)
      for (int c = 0; c < 3; ++c)
        scalar.entries.emplace_back(3 * row.points[k] + c, row.weights[k][c]);
    rows.push_back(std::move(scalar));
  }
  std::vector<int> solvedFor;
  for (const int point : block.solvedFor)
    for (int c = 0; c < 3; ++c) solvedFor.push_back(3 * point + c);
  elimination.solve(rows, solvedFor);
}

}  // namespace

AffineSpace eliminateConstraints(const QuadraticProgram& program) {
  AffineSpace space;
  Elimination elimination(3 * program.fixed.size(), kRankThreshold);
  fixPoints(program, elimination);
  space.bound = program.fixed;
  for (const ConstraintBlock& block : program.blocks) {
    solveBlock(block, elimination);
    for (const LinearRow& row : block.rows)
      for (const int point : row.points) space.bound[static_cast<std::size_t>(point)] = 1;
  }
  const auto& all = elimination.finish();
  space.rows = elimination.rank();
  space.residual = elimination.residual();
  std::vector<int> column(all.size(), -1);
  int free = 0;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].free) column[k] = free++;
  std::vector<Eigen::Triplet<double>> entries;
  space.offset = Eigen::VectorXd::Zero(static_cast<Index>(all.size()));
  for (std::size_t k = 0; k < all.size(); ++k) {
    const int row = static_cast<int>(k);
    space.offset[row] = all[k].constant[0];
    if (all[k].free) entries.emplace_back(row, column[k], 1.0);
    for (const auto& [unknown, factor] : all[k].terms) {
      FAIRING_ASSERT(all[static_cast<std::size_t>(unknown)].free);
      entries.emplace_back(row, column[static_cast<std::size_t>(unknown)], factor);
    }
  }
  space.basis.resize(static_cast<Index>(all.size()), free);
  space.basis.setFromTriplets(entries.begin(), entries.end());
  return space;
}

}  // namespace fairing::solver
