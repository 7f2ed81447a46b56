// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <memory>
#include <vector>

#include "core/solver/quadratic_program.h"

namespace fairing::solver {

/// A program in which nothing couples the coordinates (`coupled` is empty) without its inner
/// points: those that are not fixed and take part in no tie and no row. Static condensation, one
/// factorisation for x, y and z; inner points that the energy does not couple, as those of two
/// patches, are eliminated apart.
class Condensation {
 public:
  explicit Condensation(const QuadraticProgram& program);

  /// Whether all inner points could be eliminated.
  [[nodiscard]] bool isRegular() const { return isRegular_; }
  /// The program in the points that are left, in their order.
  [[nodiscard]] const QuadraticProgram& program() const { return rest_; }
  /// How many points are not.
  [[nodiscard]] int eliminated() const { return static_cast<int>(place_.size() - kept_.size()); }
  /// All points from those of program().
  [[nodiscard]] Points expanded(const Points& rest) const;

 private:
  struct Part;  // inner points that are eliminated together

  std::vector<int> kept_;   // points of the whole program
  std::vector<int> place_;  // of every point in kept_, or -1
  std::vector<std::shared_ptr<const Part>> parts_;
  QuadraticProgram rest_;
  bool isRegular_ = true;
};

}  // namespace fairing::solver
