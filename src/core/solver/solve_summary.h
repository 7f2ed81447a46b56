// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>

namespace fairing::solver {

/// Facts about a fill's way to its result. Times in seconds.
struct SolveSummary {
  int solves = 0;                   ///< linear systems solved
  int poles = 0;                    ///< control points of all patches, at the end
  int unknowns = 0;                 ///< free coordinates, at the end
  int constraints = 0;              ///< linear rows, at the end
  double energy = 0.0;              ///< of the result
  double constraintResidual = 0.0;  ///< largest left by rows that contradict each other, mm
  double layoutTime = 0.0;          ///< curves taken over or fitted
  double solveTime = 0.0;           ///< assembly and solution, last solve
  double measureTime = 0.0;
  double totalTime = 0.0;
};

}  // namespace fairing::solver
