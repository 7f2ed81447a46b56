// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/arrow_factor.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/base/parallel_for.h"

//   | A_1           B_1 |
//   |      ...      ... |      A_k = L_k L_k',  W_k = L_k^-1 B_k,  S = C - sum W_k' W_k
//   | B_1' ...      C   |

namespace fairing::solver {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Replaces the lower triangle of a matrix by its factor.
bool factorizeInPlace(MatrixXd& matrix) {
  return Eigen::LLT<Eigen::Ref<MatrixXd>>(matrix).info() == Eigen::Success;
}

std::size_t at(int k) {
  return static_cast<std::size_t>(k);
}

}  // namespace

ArrowFactor::ArrowFactor(const Sparse& pattern, const std::vector<char>& inner) {
  const int count = static_cast<int>(pattern.cols());
  place_.assign(at(count), -1);
  blockOf_.assign(at(count), -1);
  for (int k = 0; k < count; ++k)
    if (!inner[at(k)]) {
      place_[at(k)] = static_cast<int>(border_.size());
      border_.push_back(k);
    }
  for (int first = 0; first < count; ++first) {  // what an inner unknown is coupled to
    if (!inner[at(first)] || blockOf_[at(first)] >= 0) continue;
    const int number = static_cast<int>(blocks_.size());
    Block block;
    std::vector<int> open{first};
    blockOf_[at(first)] = number;
    while (!open.empty()) {
      const int unknown = open.back();
      open.pop_back();
      place_[at(unknown)] = static_cast<int>(block.own.size());
      block.own.push_back(unknown);
      for (Sparse::InnerIterator it(pattern, unknown); it; ++it) {
        const auto row = static_cast<int>(it.row());
        if (!inner[at(row)]) block.border.push_back(place_[at(row)]);
        if (!inner[at(row)] || blockOf_[at(row)] >= 0) continue;
        blockOf_[at(row)] = number;
        open.push_back(row);
      }
    }
    std::sort(block.border.begin(), block.border.end());
    block.border.erase(std::unique(block.border.begin(), block.border.end()), block.border.end());
    blocks_.push_back(std::move(block));
  }
}

double ArrowFactor::cost() const {
  const auto cube = [](double n) { return n * n * n / 3.0; };
  double sum = cube(double(border_.size()));
  for (const Block& block : blocks_) {
    const double own = double(block.own.size()), border = double(block.border.size());
    sum += cube(own) + own * own * border + own * border * border;
  }
  return sum;
}

void ArrowFactor::eliminate(const Sparse& matrix, Block& block) const {
  const auto own = static_cast<Index>(block.own.size());
  const auto border = static_cast<Index>(block.border.size());
  block.lower.setZero(own, own);
  block.across.setZero(own, border);
  for (Index c = 0; c < own; ++c)
    for (Sparse::InnerIterator it(matrix, block.own[static_cast<std::size_t>(c)]); it; ++it) {
      const auto row = static_cast<int>(it.row());
      const int place = place_[at(row)];
      if (blockOf_[at(row)] >= 0) {
        block.lower(place, c) = it.value();
        continue;
      }
      const auto found = std::lower_bound(block.border.begin(), block.border.end(), place);
      block.across(c, found - block.border.begin()) = it.value();
    }
  block.isDefinite = factorizeInPlace(block.lower);
  if (!block.isDefinite) return;
  block.lower.triangularView<Eigen::Lower>().solveInPlace(block.across);
  block.update.setZero(border, border);
  block.update.selfadjointView<Eigen::Lower>().rankUpdate(block.across.transpose());
}

bool ArrowFactor::factorize(const Sparse& matrix) {
  inParallel(blocks_.size(), [&](std::size_t k) { eliminate(matrix, blocks_[k]); });
  const auto count = static_cast<Index>(border_.size());
  lower_.setZero(count, count);
  for (Index c = 0; c < count; ++c)
    for (Sparse::InnerIterator it(matrix, border_[static_cast<std::size_t>(c)]); it; ++it)
      if (blockOf_[at(static_cast<int>(it.row()))] < 0)
        lower_(place_[at(static_cast<int>(it.row()))], c) = it.value();
  for (const Block& block : blocks_) {
    if (!block.isDefinite) return false;
    for (std::size_t c = 0; c < block.border.size(); ++c)
      for (std::size_t r = c; r < block.border.size(); ++r)  // ascending, so lower stays lower
        lower_(block.border[r], block.border[c]) -= block.update(Index(r), Index(c));
  }
  return count == 0 || factorizeInPlace(lower_);
}

VectorXd ArrowFactor::solve(const VectorXd& right) const {
  VectorXd onBorder = right(border_);
  std::vector<VectorXd> inside;
  for (const Block& block : blocks_) {
    VectorXd own = right(block.own);
    block.lower.triangularView<Eigen::Lower>().solveInPlace(own);
    onBorder(block.border) -= block.across.transpose() * own;
    inside.push_back(std::move(own));
  }
  lower_.triangularView<Eigen::Lower>().solveInPlace(onBorder);
  lower_.transpose().triangularView<Eigen::Upper>().solveInPlace(onBorder);
  VectorXd solution(right.size());
  solution(border_) = onBorder;
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    VectorXd own = inside[k] - blocks_[k].across * onBorder(blocks_[k].border);
    blocks_[k].lower.transpose().triangularView<Eigen::Upper>().solveInPlace(own);
    solution(blocks_[k].own) = own;
  }
  return solution;
}

}  // namespace fairing::solver
