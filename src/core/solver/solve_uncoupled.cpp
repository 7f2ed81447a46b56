// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/solve_uncoupled.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <array>

// Minimise 1/2 sum K_ij x_i . x_j - f . x  over X = x0 + T y, T touching the bound points only.
// Most points of a patch are inner ones, which no constraint touches; eliminated first, they leave
// a dense system as small as the border:
//   S = K_bb - K_bi K_ii^-1 K_ib,   (T'(S (x) I3)T) y = T'(r - S x0),   r = f_b - K_bi K_ii^-1 f_i
// f with the fixed points' share K x taken off; i inner, b bound.   [NocedalWright2006]
// section 16.2

namespace fairing::solver {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

enum class Role : char { Fixed, Inner, Bound };

struct Partition {
  std::vector<Role> role;         // of every point
  std::vector<int> place;         // in the list of its role
  std::vector<int> inner, bound;  // point numbers
};

Partition partition(const QuadraticProgram& program, const AffineSpace& space) {
  Partition parts;
  int fixed = 0;
  for (std::size_t p = 0; p < program.fixed.size(); ++p) {
    const Role role = program.fixed[p] ? Role::Fixed : space.bound[p] ? Role::Bound : Role::Inner;
    std::vector<int>& list = role == Role::Bound ? parts.bound : parts.inner;
    parts.role.push_back(role);
    parts.place.push_back(role == Role::Fixed ? fixed++ : static_cast<int>(list.size()));
    if (role != Role::Fixed) list.push_back(static_cast<int>(p));
  }
  return parts;
}

// The scalar stiffness by roles, and the right sides f - K x over the fixed points.
struct Blocks {
  std::vector<Eigen::Triplet<double>> inner;
  Sparse ib;
  MatrixXd bb;
  Points rightInner, rightBound;
};

void addLoad(const QuadraticProgram& program, const Partition& parts, Blocks& k) {
  if (program.load.size() == 0) return;
  const Eigen::Map<const Points> load(program.load.data(), program.load.size() / 3, 3);
  for (std::size_t i = 0; i < parts.inner.size(); ++i)
    k.rightInner.row(static_cast<Index>(i)) += load.row(parts.inner[i]);
  for (std::size_t b = 0; b < parts.bound.size(); ++b)
    k.rightBound.row(static_cast<Index>(b)) += load.row(parts.bound[b]);
}

Blocks gather(const QuadraticProgram& program, const Partition& parts) {
  const auto ni = static_cast<Index>(parts.inner.size());
  const auto nb = static_cast<Index>(parts.bound.size());
  Blocks k{{}, Sparse(ni, nb), MatrixXd::Zero(nb, nb), Points::Zero(ni, 3), Points::Zero(nb, 3)};
  std::vector<Eigen::Triplet<double>> ib;
  k.inner.reserve(static_cast<std::size_t>(program.stiffness.nonZeros()));
  for (int j = 0; j < program.stiffness.outerSize(); ++j) {
    const Role column = parts.role[static_cast<std::size_t>(j)];
    const int placeJ = parts.place[static_cast<std::size_t>(j)];
    for (Sparse::InnerIterator it(program.stiffness, j); it; ++it) {
      const Role row = parts.role[static_cast<std::size_t>(it.row())];
      const int placeI = parts.place[static_cast<std::size_t>(it.row())];
      if (row == Role::Fixed || (row == Role::Bound && column == Role::Inner)) continue;
      if (column == Role::Fixed) {
        Points& right = row == Role::Inner ? k.rightInner : k.rightBound;
        right.row(placeI) -= it.value() * program.values.row(j);
      } else if (row == Role::Bound) {
        k.bb(placeI, placeJ) = it.value();
      } else if (column == Role::Bound) {
        ib.emplace_back(placeI, placeJ, it.value());
      } else {
        k.inner.emplace_back(placeI, placeJ, it.value());
      }
    }
  }
  k.ib.setFromTriplets(ib.begin(), ib.end());
  addLoad(program, parts, k);
  return k;
}

// Cholesky factor of K_ii: dense where it is small, which is faster up to a few hundred points,
// else sparse.
class InnerFactor {
 public:
  InnerFactor(const std::vector<Eigen::Triplet<double>>& entries, Index n) : size_(n) {
    if (n <= kLargestDense) {
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
    return size_ == 0 ||
           (size_ <= kLargestDense ? dense_.info() : sparse_.info()) == Eigen::Success;
  }
  [[nodiscard]] MatrixXd solve(const MatrixXd& right) const {
    if (size_ == 0) return right;
    if (size_ <= kLargestDense) return dense_.solve(right);
    return sparse_.solve(right);
  }

 private:
  static constexpr Index kLargestDense = 200;
  Index size_;
  Eigen::LLT<MatrixXd> dense_;
  Eigen::SimplicialLLT<Sparse> sparse_;
};

// The rows of T of the bound points, in the columns they use: nb x m for each coordinate. Sparse,
// since a free unknown moves the points of its own side alone.
using BoundBasis = std::array<Sparse, 3>;

BoundBasis boundBasis(const AffineSpace& space, const Partition& parts) {
  std::vector<int> rowOf(static_cast<std::size_t>(space.basis.rows() / 3), -1);
  for (std::size_t b = 0; b < parts.bound.size(); ++b)
    rowOf[static_cast<std::size_t>(parts.bound[b])] = static_cast<int>(b);
  std::array<std::vector<Eigen::Triplet<double>>, 3> entries;
  int columns = 0;
  for (int j = 0; j < space.basis.outerSize(); ++j) {
    const Sparse::InnerIterator first(space.basis, j);
    if (!first || rowOf[static_cast<std::size_t>(first.row() / 3)] < 0) continue;
    for (Sparse::InnerIterator it(space.basis, j); it; ++it)
      entries[static_cast<std::size_t>(it.row() % 3)].emplace_back(
          rowOf[static_cast<std::size_t>(it.row() / 3)], columns, it.value());
    ++columns;
  }
  BoundBasis basis;
  for (std::size_t c = 0; c < 3; ++c) {
    basis[c].resize(static_cast<Index>(parts.bound.size()), columns);
    basis[c].setFromTriplets(entries[c].begin(), entries[c].end());
  }
  return basis;
}

// T'(S (x) I3)T without forming the Kronecker product: one product a coordinate.
MatrixXd projected(const MatrixXd& schur, const BoundBasis& basis) {
  MatrixXd result = MatrixXd::Zero(basis[0].cols(), basis[0].cols());
  for (const Sparse& rows : basis) {
    const MatrixXd reached = schur * rows;
    result += rows.transpose() * reached;
  }
  return result;
}

Result<Points> solveBound(const MatrixXd& schur,
                          Points right,
                          const AffineSpace& space,
                          const Partition& parts) {
  const auto nb = static_cast<Index>(parts.bound.size());
  Points offset(nb, 3);
  for (Index b = 0; b < nb; ++b)
    offset.row(b) =
        space.offset.segment<3>(3 * parts.bound[static_cast<std::size_t>(b)]).transpose();
  right -= schur * offset;
  const BoundBasis basis = boundBasis(space, parts);
  if (basis[0].cols() == 0) return offset;
  const Eigen::LLT<MatrixXd> factor(projected(schur, basis));
  if (factor.info() != Eigen::Success) return fail({ErrorCode::SystemSingular});
  VectorXd pull = VectorXd::Zero(basis[0].cols());
  for (Index c = 0; c < 3; ++c)
    pull += basis[static_cast<std::size_t>(c)].transpose() * right.col(c);
  const VectorXd free = factor.solve(pull);
  for (Index c = 0; c < 3; ++c) offset.col(c) += basis[static_cast<std::size_t>(c)] * free;
  return offset;
}

}  // namespace

Result<Points> solveUncoupled(const QuadraticProgram& program, const AffineSpace& space) {
  const Partition parts = partition(program, space);
  const Blocks k = gather(program, parts);
  const InnerFactor inner(k.inner, static_cast<Index>(parts.inner.size()));
  if (!inner.isRegular()) return fail({ErrorCode::SystemSingular});
  Points points = program.values;
  Points rightInner = k.rightInner;
  if (!parts.bound.empty()) {
    const MatrixXd reach = inner.solve(k.ib);
    const auto bound = solveBound(k.bb - k.ib.transpose() * reach,
                                  k.rightBound - reach.transpose() * k.rightInner,
                                  space,
                                  parts);
    if (!bound) return bound;
    rightInner -= k.ib * *bound;
    for (std::size_t b = 0; b < parts.bound.size(); ++b)
      points.row(parts.bound[b]) = bound->row(static_cast<Index>(b));
  }
  const MatrixXd innerPoints = inner.solve(rightInner);
  for (std::size_t i = 0; i < parts.inner.size(); ++i)
    points.row(parts.inner[i]) = innerPoints.row(static_cast<Index>(i));
  return points;
}

}  // namespace fairing::solver
