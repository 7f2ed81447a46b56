// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/boundary/arc_length.h"
#include "core/boundary/cut_loop.h"

namespace fairing::boundary {

enum class ChainEnds { Open, Closed };

/// Sides one after the other, by the share of their length that is behind, 0 to 1. Shares beyond go
/// round a closed chain and stop at the ends of an open one.
class ChainWalk {
 public:
  ChainWalk(const std::vector<BoundarySide>& sides,
            std::size_t first,
            std::size_t count,
            ChainEnds ends);

  /// A place next to a joint of two sides is at the start of the later one.
  [[nodiscard]] LoopPlace placeAt(double share) const;
  [[nodiscard]] Eigen::Vector3d at(double share) const;
  /// The share at which a side of the walk starts; 1 for the one after the last.
  [[nodiscard]] double startOf(std::size_t side) const;
  [[nodiscard]] double shareAt(LoopPlace place) const;

 private:
  std::size_t first_;
  ChainEnds ends_;
  std::vector<std::function<CurveSample(double)>> curves_;
  std::vector<ArcLength> arcs_;
  double length_ = 0.0;
};

}  // namespace fairing::boundary
