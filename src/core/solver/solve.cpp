// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/solve.h"

#include <Eigen/SparseCholesky>

#include "core/solver/eliminate_constraints.h"
#include "core/solver/solve_uncoupled.h"
#include "core/solver/tie_points.h"

// Minimise 1/2 X'KX - f'X over X = x0 + T y:   (T'KT) y = T'(f - K x0).   [NocedalWright2006]
// section 16.2
//   K = stiffness (x) I3 + coupled,  x0 = offset,  T = basis.

namespace fairing::solver {
namespace {

using Eigen::VectorXd;

Result<Points> solveCoupled(const QuadraticProgram& program, const AffineSpace& space) {
  const Sparse stiffness = threefold(program.stiffness) + program.coupled;
  const Sparse reduced = space.basis.transpose() * stiffness * space.basis;
  VectorXd right = -(stiffness * space.offset);
  if (program.load.size() > 0) right += program.load;
  const Eigen::SimplicialLDLT<Sparse> factor(reduced);
  if (factor.info() != Eigen::Success) return fail({ErrorCode::SystemSingular});
  const VectorXd x = space.offset + space.basis * factor.solve(space.basis.transpose() * right);
  return Points(Eigen::Map<const Points>(x.data(), x.size() / 3, 3));
}

Result<Solution> solveUntied(const QuadraticProgram& program) {
  const AffineSpace space = eliminateConstraints(program);
  const bool coupled = program.coupled.nonZeros() > 0;
  const Result<Points> points =
      coupled ? solveCoupled(program, space) : solveUncoupled(program, space);
  if (!points) return tl::unexpected<Error>(points.error());
  if (!points->allFinite()) return fail({ErrorCode::NotFinite});
  return Solution{*points, static_cast<int>(space.basis.cols()), space.rows, space.residual};
}

}  // namespace

Result<Solution> solve(const QuadraticProgram& program) {
  if (program.ties.empty()) return solveUntied(program);
  const TiedPoints tied = tiePoints(program);
  auto solution = solveUntied(withoutTies(program, tied));
  if (!solution) return solution;
  solution->points = Points(tied.basis * solution->points + tied.offset);
  solution->constraints += 3 * static_cast<int>(tied.basis.rows() - tied.basis.cols());
  solution->residual = std::max(solution->residual, tied.residual);
  return solution;
}

Sparse freedomOf(const QuadraticProgram& program) {
  const TiedPoints tied = tiePoints(program);
  return threefold(tied.basis) * eliminateConstraints(withoutTies(program, tied)).basis;
}

double energy(const QuadraticProgram& program, const Points& points) {
  return 0.5 * points.cwiseProduct(program.stiffness * points).sum();
}

}  // namespace fairing::solver
