// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

namespace fairing::solver {

/// One step towards the least energy of the shape.
struct ShapeStep {
  int level = 0;        ///< 0 on the coarsest knots, one more with every insertion
  double energy = 0.0;  ///< reached, in the energy's unit
  double anchor = 0.0;  ///< what holding the parametrisation adds to it, in the same unit
  double length = 0.0;  ///< root of the mean square of the points' displacements, mm
};

enum class ShapeEnd {
  None,       ///< no energy of the shape was asked for
  Quick,      ///< a few steps were asked for and taken
  Converged,  ///< the next step would change next to nothing
  Stopped,    ///< the caller asked for the best so far
  Limit,      ///< the limit of steps was reached: the best so far
  Undefined,  ///< the quadratic solution has no normal somewhere: it is kept
};

/// The way to the least energy of the shape, on few knots.
struct ShapeHistory {
  double start = 0.0;  ///< energy of the quadratic solution
  std::vector<ShapeStep> steps;
  ShapeEnd end = ShapeEnd::None;
  Eigen::Vector3d where = Eigen::Vector3d::Zero();  ///< where it is undefined
};

/// Facts about a fill's way to its result. Times in seconds.
struct SolveSummary {
  int solves = 0;                   ///< linear systems solved
  int poles = 0;                    ///< control points of all patches, at the end
  int unknowns = 0;                 ///< free coordinates, at the end
  int constraints = 0;              ///< linear rows, at the end
  double energy = 0.0;              ///< of the result
  double constraintResidual = 0.0;  ///< largest left by rows that contradict each other, mm
  double layoutTime = 0.0;          ///< curves taken over or fitted
  double shapeTime = 0.0;           ///< steps on the energy of the shape
  double solveTime = 0.0;           ///< assembly and solution, last solve
  double measureTime = 0.0;
  double totalTime = 0.0;
  ShapeHistory shape;
};

}  // namespace fairing::solver
