// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/solve.h"

#include "core/solver/condense.h"
#include "core/solver/eliminate_constraints.h"
#include "core/solver/guided_program.h"
#include "core/solver/solve_bound.h"
#include "core/solver/tie_points.h"

namespace fairing::solver {
namespace {

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
  const AffineSpace space = eliminateConstraints(program);
  const Result<Points> points = solveBound(program, space);
  if (!points) return tl::unexpected<Error>(points.error());
  return Solution{*points, static_cast<int>(space.basis.cols()), space.rows, space.residual};
}

Result<Solution> solveCoupled(const QuadraticProgram& program) {
  const auto n = static_cast<Eigen::Index>(program.fixed.size());
  GuidedProgram guided(program);
  guided.setGuide(program.coupled, Sparse(n, n), Eigen::VectorXd::Zero(3 * n));
  return guided.solve(1.0, 0.0);
}

Result<Solution> solveByStages(const QuadraticProgram& program) {
  if (program.coupled.nonZeros() > 0) return solveCoupled(program);
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

double energy(const Sparse& stiffness, const Points& points) {
  return 0.5 * points.cwiseProduct(stiffness * points).sum();
}

}  // namespace fairing::solver
