// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/guided_program.h"

#include <algorithm>

#include "core/solver/eliminate_constraints.h"
#include "core/solver/tie_points.h"

// Minimise 1/2 X'AX - f'X over X = x0 + T y:   (T'AT) y = T'(f - A x0).   [NocedalWright2006]
// section 16.2
//   A = stiffness (x) I3 + lambda normals + gamma points (x) I3,   x0 = offset,   T = basis.

namespace fairing::solver {
namespace {

using Eigen::VectorXd;

bool isSamePattern(const Sparse& a, const Sparse& b) {
  return a.nonZeros() == b.nonZeros() && a.cols() == b.cols() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

}  // namespace

GuidedProgram::GuidedProgram(const QuadraticProgram& program) {
  const TiedPoints tied = tiePoints(program);
  const AffineSpace space = eliminateConstraints(withoutTies(program, tied));
  const Sparse wide = threefold(tied.basis);
  basis_ = wide * space.basis;
  across_ = basis_.transpose();
  offset_ = wide * space.offset + flat(tied.offset);
  ties_ = 3 * static_cast<int>(tied.basis.rows() - tied.basis.cols());
  rows_ = space.rows;
  residual_ = std::max(space.residual, tied.residual);
  own_ = inFreedom(threefold(program.stiffness), program.load.size() > 0 ? &program.load : nullptr);
  normals_ = points_ = {Sparse(basis_.cols(), basis_.cols()), VectorXd::Zero(basis_.cols())};
}

void GuidedProgram::setGuide(const Sparse& normals, const Sparse& points, const VectorXd& load) {
  normals_ = inFreedom(normals, nullptr);
  points_ = inFreedom(threefold(points), &load);
  analyse();
}

Result<Solution> GuidedProgram::solve(double lambda, double gamma) {
  if (!factor_) analyse();
  const Sparse matrix = own_.matrix + lambda * normals_.matrix + gamma * points_.matrix;
  const VectorXd right = own_.right + lambda * normals_.right + gamma * points_.right;
  if (!factor_->factorize(matrix)) return fail({ErrorCode::SystemSingular});
  const VectorXd y = factor_->solve(right);
  const VectorXd x = offset_ + basis_ * y;
  if (!x.allFinite()) return fail({ErrorCode::NotFinite});
  return Solution{Eigen::Map<const Points>(x.data(), x.size() / 3, 3),
                  static_cast<int>(basis_.cols()),
                  ties_ + rows_,
                  residual_};
}

GuidedProgram::Part GuidedProgram::inFreedom(const Sparse& matrix, const VectorXd* load) const {
  VectorXd right = -(matrix * offset_);
  if (load) right += *load;
  return {across_ * Sparse(matrix * basis_), across_ * right};
}

void GuidedProgram::analyse() {
  Sparse pattern = own_.matrix + normals_.matrix + points_.matrix;
  if (factor_ && isSamePattern(pattern, pattern_)) return;
  factor_.emplace(pattern, basis_);
  pattern_ = std::move(pattern);
}

}  // namespace fairing::solver
