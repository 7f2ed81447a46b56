// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/solve.h"

#include <Eigen/SparseCholesky>

#include "core/solver/condense.h"
#include "core/solver/eliminate_constraints.h"
#include "core/solver/solve_bound.h"
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

using Solver = Result<Points>(const QuadraticProgram&, const AffineSpace&);

Result<Solution> solveRows(const QuadraticProgram& program, Solver& solver) {
  const AffineSpace space = eliminateConstraints(program);
  const Result<Points> points = solver(program, space);
  if (!points) return tl::unexpected<Error>(points.error());
  return Solution{*points, static_cast<int>(space.basis.cols()), space.rows, space.residual};
}

// Solves a program without its inner points.
template <class Solve>
Result<Solution> solveCondensed(const QuadraticProgram& program, const Solve& solveRest) {
  const Condensation condensed(program);
  if (!condensed.isRegular()) return fail({ErrorCode::SystemSingular});
  Result<Solution> solution = solveRest(condensed.program());
  if (!solution) return solution;
  solution->points = condensed.expanded(solution->points);
  solution->unknowns += 3 * condensed.eliminated();
  return solution;
}

// Solves a program without its ties.
template <class Solve>
Result<Solution> solveUntied(const QuadraticProgram& program, const Solve& solveRest) {
  const TiedPoints tied = tiePoints(program);
  Result<Solution> solution = solveRest(withoutTies(program, tied));
  if (!solution) return solution;
  solution->points = Points(tied.basis * solution->points + tied.offset);
  solution->constraints += 3 * static_cast<int>(tied.basis.rows() - tied.basis.cols());
  solution->residual = std::max(solution->residual, tied.residual);
  return solution;
}

Result<Solution> solveDense(const QuadraticProgram& program) {
  return solveRows(program, solveBound);
}

Result<Solution> solveSparse(const QuadraticProgram& program) {
  return solveRows(program, solveCoupled);
}

Result<Solution> solveByStages(const QuadraticProgram& program) {
  if (program.coupled.nonZeros() > 0) return solveUntied(program, solveSparse);
  return solveCondensed(program, [](const QuadraticProgram& tied) {
    if (tied.ties.empty()) return solveDense(tied);
    return solveUntied(tied, [](const QuadraticProgram& rest) {
      return solveCondensed(rest, solveDense);  // of tied points, many are in no row
    });
  });
}

}  // namespace

Result<Solution> solve(const QuadraticProgram& program) {
  auto solution = solveByStages(program);
  if (solution && !solution->points.allFinite()) return fail({ErrorCode::NotFinite});
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
