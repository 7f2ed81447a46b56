// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/block_elimination.h"

#include <Eigen/QR>
#include <algorithm>
#include <map>
#include <tuple>

namespace fairing::solver {

using Eigen::Index;
using Eigen::MatrixXd;

// A block written in free unknowns only: lead * (solved for) + rest * (handed through) = right.
template <int width>
struct BlockElimination<width>::System {
  std::vector<int> leadUnknowns, restUnknowns;
  MatrixXd lead, rest;
  Eigen::Matrix<double, Eigen::Dynamic, width> right;
};

template <int width>
void BlockElimination<width>::fix(int unknown, const Value& value) {
  all_[static_cast<std::size_t>(unknown)] = {false, value, {}};
}

template <int width>
typename BlockElimination<width>::System BlockElimination<width>::inFreeUnknowns(
    const std::vector<EliminationRow<width>>& rows, const std::vector<int>& solvedFor) const {
  System system;
  std::map<int, Index> leadColumn, restColumn;
  for (const int unknown : solvedFor)
    if (isFree(unknown) &&
        leadColumn.emplace(unknown, static_cast<Index>(system.leadUnknowns.size())).second)
      system.leadUnknowns.push_back(unknown);
  const auto count = static_cast<Index>(rows.size());
  system.lead = MatrixXd::Zero(count, static_cast<Index>(system.leadUnknowns.size()));
  system.right.setZero(count, width);
  std::vector<std::tuple<Index, Index, double>> restEntries;
  const auto addFree = [&](Index r, int unknown, double weight) {
    if (const auto found = leadColumn.find(unknown); found != leadColumn.end()) {
      system.lead(r, found->second) += weight;
      return;
    }
    const auto [entry, isNew] = restColumn.emplace(unknown, static_cast<Index>(restColumn.size()));
    if (isNew) system.restUnknowns.push_back(unknown);
    restEntries.emplace_back(r, entry->second, weight);
  };
  for (Index r = 0; r < count; ++r) {
    system.right.row(r) = rows[static_cast<std::size_t>(r)].right;
    for (const auto& [unknown, weight] : rows[static_cast<std::size_t>(r)].entries) {
      if (isFree(unknown)) {
        addFree(r, unknown, weight);
        continue;
      }
      system.right.row(r) -= weight * at(unknown).constant;
      for (const auto& [other, factor] : at(unknown).terms) addFree(r, other, weight * factor);
    }
  }
  system.rest = MatrixXd::Zero(count, static_cast<Index>(system.restUnknowns.size()));
  for (const auto& [r, c, weight] : restEntries) system.rest(r, c) += weight;
  return system;
}

// Writes the pivot unknowns of the block as expressions of the others.
//   lead P = Q [R1 R2; 0 0],  x_pivot = R1^-1 (Q' right - R2 x_others - Q' rest x_rest)
template <int width>
void BlockElimination<width>::solve(const std::vector<EliminationRow<width>>& blockRows,
                                    const std::vector<int>& solvedFor) {
  const System system = inFreeUnknowns(blockRows, solvedFor);
  if (system.lead.size() == 0) {  // no rows, or all they could be solved for is known already
    residual_ = std::max(residual_, system.right.template lpNorm<Eigen::Infinity>());
    return;
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(system.lead.rows(), system.lead.cols());
  qr.setThreshold(rankThreshold_);
  qr.compute(system.lead);
  const Index rank = qr.rank(), rows = system.lead.rows(), columns = system.lead.cols();
  rank_ += static_cast<int>(rank);
  MatrixXd known(rows, width + system.rest.cols());
  known << system.right, system.rest;
  known.applyOnTheLeft(qr.householderQ().setLength(qr.nonzeroPivots()).transpose());
  if (rank < rows)
    residual_ = std::max(
        residual_, known.template leftCols<width>().bottomRows(rows - rank).cwiseAbs().maxCoeff());
  if (rank == 0) return;
  const auto triangle =
      qr.matrixR().topLeftCorner(rank, rank).template triangularView<Eigen::Upper>();
  const MatrixXd solved = triangle.solve(known.topRows(rank));
  MatrixXd others = qr.matrixR().topRightCorner(rank, columns - rank);
  if (others.size() > 0) triangle.solveInPlace(others);
  const auto unknownAt = [&](Index column) {
    return system.leadUnknowns[static_cast<std::size_t>(qr.colsPermutation().indices()[column])];
  };
  for (Index k = 0; k < rank; ++k) {
    pivots_.push_back(unknownAt(k));
    Expression<width>& pivot = all_[static_cast<std::size_t>(unknownAt(k))];
    pivot.free = false;
    pivot.constant = solved.row(k).template head<width>();
    for (Index j = rank; j < columns; ++j)
      pivot.terms.emplace_back(unknownAt(j), -others(k, j - rank));
    for (Index j = 0; j < system.rest.cols(); ++j)
      pivot.terms.emplace_back(system.restUnknowns[static_cast<std::size_t>(j)],
                               -solved(k, width + j));
  }
}

// What later blocks have solved for is replaced by what they found, the last ones first.
template <int width>
const std::vector<Expression<width>>& BlockElimination<width>::finish() {
  for (auto it = pivots_.rbegin(); it != pivots_.rend(); ++it) {
    Expression<width>& pivot = all_[static_cast<std::size_t>(*it)];
    std::map<int, double> terms;
    for (const auto& [unknown, factor] : pivot.terms) {
      const Expression<width>& other = at(unknown);
      if (other.free)
        terms[unknown] += factor;
      else
        pivot.constant += factor * other.constant;
      for (const auto& [far, farFactor] : other.terms) terms[far] += factor * farFactor;
    }
    pivot.terms.assign(terms.begin(), terms.end());
  }
  return all_;
}

template class BlockElimination<1>;
template class BlockElimination<3>;

}  // namespace fairing::solver
