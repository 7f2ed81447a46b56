// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <optional>

namespace fairing {

/// How far a strip reaches before it turns away from either side, as a factor of what its energy
/// likes best: the length of the cross tangents. Entry 0 is the first chain's.
struct Reach {
  std::array<double, 2> start{1.0, 1.0};
  /// At the end of the side, linear between, in the parameter of the strip; none: as at the start,
  /// all along. A side starts where its chain does (boundary/side_chain.h).
  std::array<std::optional<double>, 2> end = {};

  [[nodiscard]] double at(std::size_t side, double t) const {
    return start[side] + t * (end[side].value_or(start[side]) - start[side]);
  }
  [[nodiscard]] bool varies(std::size_t side) const {
    return end[side] && *end[side] != start[side];
  }
  [[nodiscard]] bool isNatural() const {
    return start == std::array{1.0, 1.0} && !varies(0) && !varies(1);
  }
};

}  // namespace fairing
