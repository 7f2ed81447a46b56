// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/tie_points.h"

#include <Eigen/QR>
#include <algorithm>
#include <map>

#include "core/base/assert.h"

namespace fairing::solver {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

// Rows smaller than this beside the largest are taken for dependent. Weights are of the order of 1.
constexpr double kRankThreshold = 1e-9;

// One point: free, or constant + sum of factors times free ones.
struct Expression {
  bool free = true;
  Vector3d constant = Vector3d::Zero();
  std::vector<std::pair<int, double>> terms;
};
using Expressions = std::vector<Expression>;

// A block written in free points only: lead * (solved for) + rest * (handed through) = right.
struct BlockSystem {
  std::vector<int> leadPoints, restPoints;
  MatrixXd lead, rest;
  Points right;
};

class SystemBuilder {
 public:
  SystemBuilder(const TieBlock& block, const Expressions& all) : all_(all) {
    for (const int point : block.solvedFor)
      if (all[static_cast<std::size_t>(point)].free &&
          leadColumn_.emplace(point, static_cast<Index>(system_.leadPoints.size())).second)
        system_.leadPoints.push_back(point);
    const auto rows = static_cast<Index>(block.rows.size());
    system_.lead = MatrixXd::Zero(rows, static_cast<Index>(system_.leadPoints.size()));
    system_.right = Points::Zero(rows, 3);
    for (Index r = 0; r < rows; ++r) addRow(r, block.rows[static_cast<std::size_t>(r)]);
    system_.rest = MatrixXd::Zero(rows, static_cast<Index>(system_.restPoints.size()));
    for (const auto& [r, c, weight] : restEntries_) system_.rest(r, c) += weight;
  }
  [[nodiscard]] BlockSystem take() && { return std::move(system_); }

 private:
  void addRow(Index r, const TieRow& row) {
    system_.right.row(r) = row.right.transpose();
    for (std::size_t k = 0; k < row.points.size(); ++k) {
      const Expression& expression = all_[static_cast<std::size_t>(row.points[k])];
      const double weight = row.weights[k];
      if (expression.free) {
        addFree(r, row.points[k], weight);
        continue;
      }
      system_.right.row(r) -= weight * expression.constant.transpose();
      for (const auto& [other, factor] : expression.terms) addFree(r, other, weight * factor);
    }
  }
  void addFree(Index r, int point, double weight) {
    if (const auto found = leadColumn_.find(point); found != leadColumn_.end()) {
      system_.lead(r, found->second) += weight;
      return;
    }
    const auto [entry, isNew] = restColumn_.emplace(point, static_cast<Index>(restColumn_.size()));
    if (isNew) system_.restPoints.push_back(point);
    restEntries_.emplace_back(r, entry->second, weight);
  }

  const Expressions& all_;
  BlockSystem system_;
  std::map<int, Index> leadColumn_, restColumn_;
  std::vector<std::tuple<Index, Index, double>> restEntries_;
};

//   lead P = Q [R1 R2; 0 0],  x_pivot = R1^-1 (Q' right - R2 x_others - Q' rest x_rest)
void solveBlock(const BlockSystem& system,
                Expressions& all,
                std::vector<int>& pivots,
                TiedPoints& tied) {
  if (system.lead.size() == 0) {
    if (system.right.size() > 0)
      tied.residual = std::max(tied.residual, system.right.cwiseAbs().maxCoeff());
    return;
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(system.lead.rows(), system.lead.cols());
  qr.setThreshold(kRankThreshold);
  qr.compute(system.lead);
  const Index rank = qr.rank(), rows = system.lead.rows(), columns = system.lead.cols();
  MatrixXd known(rows, 3 + system.rest.cols());
  known << system.right, system.rest;
  known.applyOnTheLeft(qr.householderQ().setLength(qr.nonzeroPivots()).transpose());
  if (rank < rows)
    tied.residual =
        std::max(tied.residual, known.leftCols<3>().bottomRows(rows - rank).cwiseAbs().maxCoeff());
  if (rank == 0) return;
  const auto triangle =
      qr.matrixR().topLeftCorner(rank, rank).template triangularView<Eigen::Upper>();
  const MatrixXd solved = triangle.solve(known.topRows(rank));
  MatrixXd others = qr.matrixR().topRightCorner(rank, columns - rank);
  if (others.size() > 0) triangle.solveInPlace(others);
  const auto pointAt = [&](Index column) {
    return system.leadPoints[static_cast<std::size_t>(qr.colsPermutation().indices()[column])];
  };
  for (Index k = 0; k < rank; ++k) {
    Expression& pivot = all[static_cast<std::size_t>(pointAt(k))];
    pivots.push_back(pointAt(k));
    pivot.free = false;
    pivot.constant = solved.row(k).head<3>().transpose();
    for (Index j = rank; j < columns; ++j)
      pivot.terms.emplace_back(pointAt(j), -others(k, j - rank));
    for (Index j = 0; j < system.rest.cols(); ++j)
      pivot.terms.emplace_back(system.restPoints[static_cast<std::size_t>(j)], -solved(k, 3 + j));
  }
}

// What later blocks have solved for is replaced by what they found, the last ones first.
void substitute(const std::vector<int>& pivots, Expressions& all) {
  for (auto it = pivots.rbegin(); it != pivots.rend(); ++it) {
    Expression& pivot = all[static_cast<std::size_t>(*it)];
    std::map<int, double> terms;
    for (const auto& [point, factor] : pivot.terms) {
      const Expression& other = all[static_cast<std::size_t>(point)];
      if (other.free)
        terms[point] += factor;
      else
        pivot.constant += factor * other.constant;
      for (const auto& [far, farFactor] : other.terms) terms[far] += factor * farFactor;
    }
    pivot.terms.assign(terms.begin(), terms.end());
  }
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

TiedPoints tiePoints(const QuadraticProgram& program) {
  TiedPoints tied;
  Expressions all(program.fixed.size());
  std::vector<int> pivots;
  for (std::size_t p = 0; p < all.size(); ++p)
    if (program.fixed[p])
      all[p] = {false, program.values.row(static_cast<Index>(p)).transpose(), {}};
  for (const TieBlock& block : program.ties)
    solveBlock(SystemBuilder(block, all).take(), all, pivots, tied);
  substitute(pivots, all);
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
    tied.offset.row(row) = all[p].constant.transpose();
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
  reduced.stiffness = basis.transpose() * program.stiffness * basis;
  const auto n = static_cast<Index>(program.fixed.size());
  Points load = -(program.stiffness * tied.offset);
  if (program.load.size() > 0) load += Eigen::Map<const Points>(program.load.data(), n, 3);
  if (program.coupled.nonZeros() > 0) {
    const Sparse wide = threefold(basis);
    reduced.coupled = wide.transpose() * program.coupled * wide;
    const Eigen::VectorXd pulled =
        program.coupled * Eigen::Map<const Eigen::VectorXd>(tied.offset.data(), 3 * n);
    load -= Eigen::Map<const Points>(pulled.data(), n, 3);
  }
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
