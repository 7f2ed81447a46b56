// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/height_system.h"

#include <Eigen/SparseCholesky>
#include <cmath>

// E(x) = 1/2 x'Kx - g'x is to be least among the minimisers of |Ax - b|^2. Bregman iteration
// [OsherBurgerGoldfarbXuYin2005], here the same as iterated Tikhonov regularisation:
//   (K + w A'A) x_1 = w A'b + g,   (K + w A'A) x_k+1 = w A'b + K x_k
// with one factorisation. What rows determine well converges at once, however small w is; what they
// hardly determine is left to the energy, so that neither a huge w nor a rank decision is needed.

namespace fairing::height_field {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the mean diagonal of K: A'A is scaled to this share of it.
constexpr double kStiffness = 1e5;
constexpr int kRounds = 6;
// Against poles no row and hardly any energy touches.
constexpr double kTiny = 1e-13;

}  // namespace

void CellSquares::add(const JetBasis& at, const EnergySquare& square) {
  at_ = at;
  const double root = std::sqrt(square.weight);
  const VectorXd row = root * at.values.transpose() * square.form;
  rows_.insert(rows_.end(), row.begin(), row.end());
  rights_.push_back(root * square.right);
}

HeightSystem::HeightSystem(spline::KnotVector u, spline::KnotVector v)
    : u_(std::move(u)), v_(std::move(v)) {
  const Index poles = static_cast<Index>(u_.poleCount()) * v_.poleCount();
  const Index offsets = static_cast<Index>(u_.degree() + 1) * (2 * v_.degree() + 1);
  energy_.entries = squares_.entries = MatrixXd::Zero(offsets, poles);
  load_ = target_ = VectorXd::Zero(poles);
}

int HeightSystem::index(const JetBasis& at, int local) const {
  const int nv = v_.degree() + 1;
  return (at.firstU + local / nv) * v_.poleCount() + at.firstV + local % nv;
}

// Offsets of a pole (i, j) to a later one (i + a, j + b): a from 0 on, b from -degree on.
void HeightSystem::add(Stencil& stencil, const JetBasis& at, const MatrixXd& block) const {
  const int nu = u_.degree() + 1, nv = v_.degree() + 1, width = 2 * v_.degree() + 1;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const int pole = index(at, i * nv + j);
      for (int k = i; k < nu; ++k)
        for (int l = 0; l < nv; ++l)
          stencil.entries((k - i) * width + l - j + v_.degree(), pole) +=
              block(i * nv + j, k * nv + l);
    }
}

HeightSystem::Sparse HeightSystem::toSparse(const Stencil& stencil) const {
  const int n = v_.poleCount(), width = 2 * v_.degree() + 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index pole = 0; pole < stencil.entries.cols(); ++pole) {
    const int i = static_cast<int>(pole) / n, j = static_cast<int>(pole) % n;
    for (int a = 0; a <= u_.degree() && i + a < u_.poleCount(); ++a)
      for (int b = -v_.degree(); b <= v_.degree(); ++b) {
        if (j + b < 0 || j + b >= n || (a == 0 && b < 0)) continue;
        entries.emplace_back(
            (i + a) * n + j + b, pole, stencil.entries(a * width + b + v_.degree(), pole));
      }
  }
  Sparse lower(stencil.entries.cols(), stencil.entries.cols());
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

void HeightSystem::addRow(const HeightRow& row) {
  const JetBasis at = jetBasis(u_, v_, row.u, row.v);
  const VectorXd entries = at.values.transpose() * row.form;
  add(squares_, at, row.weight * entries * entries.transpose());
  for (int k = 0; k < entries.size(); ++k)
    target_[index(at, k)] += row.weight * row.right * entries[k];
  ++rows_;
}

void HeightSystem::addEnergy(const CellSquares& cell) {
  const auto count = static_cast<Index>(cell.rights_.size());
  const auto width = static_cast<Index>(cell.rows_.size()) / count;
  const Eigen::Map<const MatrixXd> rows(cell.rows_.data(), width, count);
  add(energy_, cell.at_, rows * rows.transpose());
  const VectorXd loads = rows * Eigen::Map<const VectorXd>(cell.rights_.data(), count);
  for (int k = 0; k < loads.size(); ++k) load_[index(cell.at_, k)] += loads[k];
}

Result<Heights> HeightSystem::solve() const {
  const Sparse energy = toSparse(energy_), squares = toSparse(squares_);
  const double scale = energy.diagonal().maxCoeff();
  const double weight = kStiffness * scale / squares.diagonal().maxCoeff();
  Sparse sum = energy + weight * squares;
  for (Index k = 0; k < sum.rows(); ++k) sum.coeffRef(k, k) += kTiny * scale;
  const Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factor(sum);
  if (factor.info() != Eigen::Success) return fail({ErrorCode::SystemSingular});
  VectorXd x = factor.solve(weight * target_ + load_);
  for (int round = 1; round < kRounds; ++round) {
    const VectorXd right =
        weight * target_ + energy.selfadjointView<Eigen::Lower>() * x + kTiny * scale * x;
    x = factor.solve(right);
  }
  if (!x.allFinite()) return fail({ErrorCode::NotFinite});
  return Heights{u_, v_, std::move(x)};
}

double HeightSystem::energy(const Heights& heights) const {
  const VectorXd& x = heights.poles;
  return 0.5 * x.dot(toSparse(energy_).selfadjointView<Eigen::Lower>() * x) - load_.dot(x);
}

}  // namespace fairing::height_field
