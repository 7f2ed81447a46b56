// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <functional>
#include <vector>

#include "core/boundary/ribbon.h"

namespace fairing::boundary {

/// Arc length over the stretch [from, to], from < to, of a ribbon's curve; mm. Good to about 1e-12
/// of the length where the curve is smooth between its knots. Costs about 300 evaluations to make
/// and five a query.
class ArcLength {
 public:
  ArcLength(const Ribbon& ribbon, double from, double to);

  [[nodiscard]] double length() const { return nodes_.back().length; }
  /// Length of the stretch up to a parameter, mm.
  [[nodiscard]] double lengthUpTo(double t) const;
  /// The curve's parameter where `length` mm of the stretch are behind.
  [[nodiscard]] double parameterAt(double length) const;

 private:
  struct Node {
    double t, length, speed;
  };
  [[nodiscard]] double between(double a, double b) const;

  std::function<CurveSample(double t)> curve_;
  std::vector<Node> nodes_;
};

}  // namespace fairing::boundary
