// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/condense.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <algorithm>

// With i inner points and r the rest, f with the fixed points' share K x taken off:
//   x_i = K_ii^-1 (f_i - K_ir x_r),   S = K_rr - K_ri K_ii^-1 K_ir,   f_r - K_ri K_ii^-1 f_i
// By the halves  W = L^-1 P K_ir,  w = L^-1 P f_i  of a factorisation  P K_ii P' = L L':
//   S = K_rr - W'W,   f_r - W'w,   x_i = P' L^-T (w - W x_r)      [NocedalWright2006] section 16.2

namespace fairing::solver {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Entries = std::vector<Eigen::Triplet<double>>;

// Dense where it is small, which is faster up to a few hundred points, else sparse.
class Factor {
 public:
  Factor(const Entries& entries, Index n) : isDense_(n <= kLargestDense) {
    if (isDense_) {
      MatrixXd matrix = MatrixXd::Zero(n, n);
      for (const auto& e : entries) matrix(e.row(), e.col()) = e.value();
      dense_.compute(matrix);
    } else {
      Sparse matrix(n, n);
      matrix.setFromTriplets(entries.begin(), entries.end());
      sparse_.compute(matrix);
    }
  }
  [[nodiscard]] bool isRegular() const {
    return (isDense_ ? dense_.info() : sparse_.info()) == Eigen::Success;
  }
  // L^-1 P right
  [[nodiscard]] MatrixXd half(const MatrixXd& right) const {
    if (isDense_) return dense_.matrixL().solve(right);
    return sparse_.matrixL().solve(MatrixXd(sparse_.permutationP() * right));
  }
  // P' L^-T right
  [[nodiscard]] Points otherHalf(const Points& right) const {
    if (isDense_) return dense_.matrixU().solve(right);
    return sparse_.permutationPinv() * sparse_.matrixU().solve(MatrixXd(right));
  }

 private:
  static constexpr Index kLargestDense = 400;
  bool isDense_;
  Eigen::LLT<MatrixXd> dense_;
  Eigen::SimplicialLLT<Sparse> sparse_;
};

std::vector<char> innerPoints(const QuadraticProgram& program) {
  std::vector<char> inner;
  for (const char fixed : program.fixed) inner.push_back(fixed ? 0 : 1);
  const auto leaveOut = [&](const auto& blocks) {
    for (const auto& block : blocks)
      for (const auto& row : block.rows)
        for (const int point : row.points) inner[static_cast<std::size_t>(point)] = 0;
  };
  leaveOut(program.ties);
  leaveOut(program.blocks);
  return inner;
}

// Inner points by what couples them; every list ascends.
std::vector<std::vector<int>> connected(const Sparse& stiffness, const std::vector<char>& inner) {
  std::vector<std::vector<int>> parts;
  std::vector<char> isOpen = inner;
  for (int start = 0; start < stiffness.outerSize(); ++start) {
    if (!isOpen[static_cast<std::size_t>(start)]) continue;
    std::vector<int> part{start};
    isOpen[static_cast<std::size_t>(start)] = 0;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (Sparse::InnerIterator it(stiffness, part[k]); it; ++it) {
        char& open = isOpen[static_cast<std::size_t>(it.row())];
        if (open) part.push_back(static_cast<int>(it.row()));
        open = 0;
      }
    std::sort(part.begin(), part.end());
    parts.push_back(std::move(part));
  }
  return parts;
}

Points loadOf(const QuadraticProgram& program) {
  const auto n = static_cast<Index>(program.fixed.size());
  if (program.load.size() == 0) return Points::Zero(n, 3);
  return Eigen::Map<const Points>(program.load.data(), n, 3);
}

template <class Block>
std::vector<Block> renumbered(std::vector<Block> blocks, const std::vector<int>& place) {
  const auto renumber = [&](std::vector<int>& points) {
    for (int& point : points) point = place[static_cast<std::size_t>(point)];
  };
  for (Block& block : blocks) {
    renumber(block.solvedFor);
    for (auto& row : block.rows) renumber(row.points);
  }
  return blocks;
}

}  // namespace

struct Condensation::Part {
  Part(const QuadraticProgram& program, const Points& load, const std::vector<int>& points)
      : Part(gather(program, load, points), points) {}

  std::vector<int> inner, others;  // points of the whole program
  Factor factor;
  MatrixXd reach;  // W
  Points own;      // w

 private:
  struct Gathered {
    std::vector<int> others;
    Entries inner, reach;
    Points right;
  };
  Part(Gathered&& gathered, const std::vector<int>& points);
  static Gathered gather(const QuadraticProgram& program,
                         const Points& load,
                         const std::vector<int>& inner);
};

Condensation::Part::Gathered Condensation::Part::gather(const QuadraticProgram& program,
                                                        const Points& load,
                                                        const std::vector<int>& inner) {
  Gathered g;
  g.right.resize(static_cast<Index>(inner.size()), 3);
  constexpr int kNone = -1;
  std::vector<int> row(program.fixed.size(), kNone), column = row;
  for (std::size_t k = 0; k < inner.size(); ++k)
    row[static_cast<std::size_t>(inner[k])] = static_cast<int>(k);
  for (std::size_t k = 0; k < inner.size(); ++k) {
    const auto here = static_cast<Index>(k);
    g.right.row(here) = load.row(inner[k]);
    for (Sparse::InnerIterator it(program.stiffness, inner[k]); it; ++it) {
      const auto other = static_cast<std::size_t>(it.row());
      if (program.fixed[other]) {
        g.right.row(here) -= it.value() * program.values.row(it.row());
      } else if (row[other] != kNone) {
        g.inner.emplace_back(row[other], static_cast<int>(k), it.value());
      } else {
        if (column[other] == kNone) {
          column[other] = static_cast<int>(g.others.size());
          g.others.push_back(static_cast<int>(it.row()));
        }
        g.reach.emplace_back(static_cast<int>(k), column[other], it.value());
      }
    }
  }
  return g;
}

Condensation::Part::Part(Gathered&& gathered, const std::vector<int>& points)
    : inner(points),
      others(std::move(gathered.others)),
      factor(gathered.inner, static_cast<Index>(inner.size())) {
  if (!factor.isRegular()) return;
  const auto n = static_cast<Index>(inner.size()), m = static_cast<Index>(others.size());
  MatrixXd right = MatrixXd::Zero(n, m + 3);
  for (const auto& e : gathered.reach) right(e.row(), e.col()) = e.value();
  right.rightCols<3>() = gathered.right;
  const MatrixXd half = factor.half(right);
  reach = half.leftCols(m);
  own = half.rightCols<3>();
}

Condensation::Condensation(const QuadraticProgram& program) {
  const std::vector<char> inner = innerPoints(program);
  for (std::size_t p = 0; p < inner.size(); ++p) {
    place_.push_back(inner[p] ? -1 : static_cast<int>(kept_.size()));
    if (!inner[p]) kept_.push_back(static_cast<int>(p));
  }
  const auto placeOf = [&](int point) { return place_[static_cast<std::size_t>(point)]; };
  Entries entries;
  for (const int j : kept_)
    for (Sparse::InnerIterator it(program.stiffness, j); it; ++it)
      if (const int row = placeOf(static_cast<int>(it.row())); row >= 0)
        entries.emplace_back(row, placeOf(j), it.value());
  Points load = loadOf(program);
  for (const std::vector<int>& points : connected(program.stiffness, inner)) {
    const auto part = std::make_shared<const Part>(program, load, points);
    isRegular_ = isRegular_ && part->factor.isRegular();
    if (!isRegular_) return;
    parts_.push_back(part);
    const auto m = static_cast<Index>(part->others.size());
    if (m == 0) continue;  // all beside it is fixed
    MatrixXd lost = MatrixXd::Zero(m, m);
    lost.selfadjointView<Eigen::Lower>().rankUpdate(part->reach.transpose());
    const Points pulled = part->reach.transpose() * part->own;
    for (Index b = 0; b < m; ++b) {
      const int other = part->others[static_cast<std::size_t>(b)];
      load.row(other) -= pulled.row(b);
      for (Index a = 0; a < m; ++a)
        entries.emplace_back(placeOf(part->others[static_cast<std::size_t>(a)]),
                             placeOf(other),
                             -lost(std::max(a, b), std::min(a, b)));
    }
  }
  const auto n = static_cast<Index>(kept_.size());
  rest_.stiffness.resize(n, n);
  rest_.stiffness.setFromTriplets(entries.begin(), entries.end());
  rest_.load.resize(3 * n);
  rest_.values.setZero(n, 3);
  for (Index k = 0; k < n; ++k) {
    const int point = kept_[static_cast<std::size_t>(k)];
    rest_.load.segment<3>(3 * k) = load.row(point).transpose();
    rest_.fixed.push_back(program.fixed[static_cast<std::size_t>(point)]);
    if (rest_.fixed.back()) rest_.values.row(k) = program.values.row(point);
  }
  rest_.ties = renumbered(program.ties, place_);
  rest_.blocks = renumbered(program.blocks, place_);
}

Points Condensation::expanded(const Points& rest) const {
  Points all(static_cast<Index>(place_.size()), 3);
  for (std::size_t k = 0; k < kept_.size(); ++k)
    all.row(kept_[k]) = rest.row(static_cast<Index>(k));
  for (const auto& part : parts_) {
    Points others(static_cast<Index>(part->others.size()), 3);
    for (std::size_t b = 0; b < part->others.size(); ++b)
      others.row(static_cast<Index>(b)) = all.row(part->others[b]);
    Points right = part->own;
    if (others.rows() > 0) right -= part->reach * others;
    const Points inner = part->factor.otherHalf(right);
    for (std::size_t i = 0; i < part->inner.size(); ++i)
      all.row(part->inner[i]) = inner.row(static_cast<Index>(i));
  }
  return all;
}

}  // namespace fairing::solver
