// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/eliminate_constraints.h"

#include <Eigen/QR>
#include <algorithm>
#include <map>

#include "core/base/assert.h"

namespace fairing::solver {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Rows smaller than this beside the largest are taken for dependent. Weights are basis values times
// unit vectors.
constexpr double kRankThreshold = 1e-10;

// One scalar unknown: free, or constant + sum of coefficients times free ones.
struct Expression {
  bool free = true;
  double constant = 0.0;
  std::vector<std::pair<int, double>> terms;
};

using Expressions = std::vector<Expression>;

// A block written in free scalars only: lead * (solved for) + rest * (handed through) = right.
struct BlockSystem {
  std::vector<int> leadUnknowns, restUnknowns;
  MatrixXd lead, rest;
  VectorXd right;
};

BlockSystem buildSystem(const ConstraintBlock& block, const Expressions& all) {
  BlockSystem system;
  std::map<int, Index> leadColumn, restColumn;
  for (const int point : block.solvedFor)
    for (int c = 0; c < 3; ++c)
      if (all[static_cast<std::size_t>(3 * point + c)].free) {
        leadColumn.emplace(3 * point + c, static_cast<Index>(system.leadUnknowns.size()));
        system.leadUnknowns.push_back(3 * point + c);
      }
  const Index m = static_cast<Index>(block.rows.size());
  std::vector<std::tuple<Index, Index, double>> restEntries;
  system.lead = MatrixXd::Zero(m, static_cast<Index>(system.leadUnknowns.size()));
  system.right = VectorXd::Zero(m);
  for (Index r = 0; r < m; ++r) {
    const LinearRow& row = block.rows[static_cast<std::size_t>(r)];
    system.right[r] = row.right;
    const auto addFree = [&](int unknown, double weight) {
      if (const auto found = leadColumn.find(unknown); found != leadColumn.end()) {
        system.lead(r, found->second) += weight;
        return;
      }
      const auto [entry, isNew] =
          restColumn.emplace(unknown, static_cast<Index>(restColumn.size()));
      if (isNew) system.restUnknowns.push_back(unknown);
      restEntries.emplace_back(r, entry->second, weight);
    };
    for (std::size_t k = 0; k < row.points.size(); ++k)
      for (int c = 0; c < 3; ++c) {
        const int unknown = 3 * row.points[k] + c;
        const Expression& expression = all[static_cast<std::size_t>(unknown)];
        const double weight = row.weights[k][c];
        if (expression.free) {
          addFree(unknown, weight);
          continue;
        }
        system.right[r] -= weight * expression.constant;
        for (const auto& [other, factor] : expression.terms) addFree(other, weight * factor);
      }
  }
  system.rest = MatrixXd::Zero(m, static_cast<Index>(system.restUnknowns.size()));
  for (const auto& [r, c, weight] : restEntries) system.rest(r, c) += weight;
  return system;
}

// Writes the pivot unknowns of the block as expressions of the others.
//   lead P = Q [R1 R2; 0 0],  x_pivot = R1^-1 (Q' right - R2 x_others - Q' rest x_rest)
void solveBlock(const BlockSystem& system,
                Expressions& all,
                std::vector<int>& pivots,
                AffineSpace& space) {
  if (system.lead.size() == 0) {  // no rows, or all they could be solved for is known already
    space.residual = std::max(space.residual, system.right.lpNorm<Eigen::Infinity>());
    return;
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(system.lead.rows(), system.lead.cols());
  qr.setThreshold(kRankThreshold);
  qr.compute(system.lead);
  const Index rank = qr.rank(), rows = system.lead.rows(), columns = system.lead.cols();
  space.rows += static_cast<int>(rank);
  MatrixXd known(rows, 1 + system.rest.cols());
  known << system.right, system.rest;
  known.applyOnTheLeft(qr.householderQ().setLength(qr.nonzeroPivots()).transpose());
  if (rank < rows)
    space.residual = std::max(space.residual, known.col(0).tail(rows - rank).cwiseAbs().maxCoeff());
  if (rank == 0) return;
  const auto triangle =
      qr.matrixR().topLeftCorner(rank, rank).template triangularView<Eigen::Upper>();
  const MatrixXd solved = triangle.solve(known.topRows(rank));
  MatrixXd others = qr.matrixR().topRightCorner(rank, columns - rank);
  if (others.size() > 0) triangle.solveInPlace(others);
  const auto& order = qr.colsPermutation().indices();
  const auto unknownAt = [&](Index column) {
    return system.leadUnknowns[static_cast<std::size_t>(order[column])];
  };
  for (Index k = 0; k < rank; ++k) {
    Expression& pivot = all[static_cast<std::size_t>(unknownAt(k))];
    pivots.push_back(unknownAt(k));
    pivot.free = false;
    pivot.constant = solved(k, 0);
    for (Index j = rank; j < columns; ++j)
      pivot.terms.emplace_back(unknownAt(j), -others(k, j - rank));
    for (Index j = 0; j < system.rest.cols(); ++j)
      pivot.terms.emplace_back(system.restUnknowns[static_cast<std::size_t>(j)], -solved(k, 1 + j));
  }
}

// What later blocks have solved for is replaced by what they found, the last ones first.
void substitute(const std::vector<int>& pivots, Expressions& all) {
  for (auto it = pivots.rbegin(); it != pivots.rend(); ++it) {
    Expression& pivot = all[static_cast<std::size_t>(*it)];
    std::map<int, double> terms;
    for (const auto& [unknown, factor] : pivot.terms) {
      const Expression& other = all[static_cast<std::size_t>(unknown)];
      if (other.free)
        terms[unknown] += factor;
      else
        pivot.constant += factor * other.constant;
      for (const auto& [far, farFactor] : other.terms) terms[far] += factor * farFactor;
    }
    pivot.terms.assign(terms.begin(), terms.end());
  }
}

Expressions fixedPoints(const QuadraticProgram& program) {
  Expressions all(3 * program.fixed.size());
  for (std::size_t p = 0; p < program.fixed.size(); ++p)
    for (std::size_t c = 0; program.fixed[p] && c < 3; ++c) {
      all[3 * p + c].free = false;
      all[3 * p + c].constant = program.values(static_cast<Index>(p), static_cast<Index>(c));
    }
  return all;
}

}  // namespace

AffineSpace eliminateConstraints(const QuadraticProgram& program) {
  AffineSpace space;
  Expressions all = fixedPoints(program);
  std::vector<int> pivots;
  space.bound = program.fixed;
  for (const ConstraintBlock& block : program.blocks) {
    solveBlock(buildSystem(block, all), all, pivots, space);
    for (const LinearRow& row : block.rows)
      for (const int point : row.points) space.bound[static_cast<std::size_t>(point)] = 1;
  }
  substitute(pivots, all);
  std::vector<int> column(all.size(), -1);
  int free = 0;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].free) column[k] = free++;
  std::vector<Eigen::Triplet<double>> entries;
  space.offset = VectorXd::Zero(static_cast<Index>(all.size()));
  for (std::size_t k = 0; k < all.size(); ++k) {
    const int row = static_cast<int>(k);
    space.offset[row] = all[k].constant;
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
