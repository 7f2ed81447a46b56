// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <vector>

#include "core/boundary/arc_length.h"
#include "core/boundary/cut_loop.h"

namespace fairing::layout {

/// What a place where two edges meet is to a layout.
enum class CornerRole {
  Smooth,  ///< no corner: the edges continue each other
  Corner,  ///< convex: one patch has its corner here
  Split,   ///< nearly straight or re-entrant: two patches meet here, lest one degenerates
};

/// By corner of the loop: corner k is at the end of side k.
[[nodiscard]] std::vector<CornerRole> cornerRoles(const boundary::BoundaryLoop& loop);

/// Lengths along a closed chain of a loop, from the start of its first side on.
class LoopLength {
 public:
  explicit LoopLength(const boundary::BoundaryLoop& loop)
      : LoopLength(loop, 0, loop.sides.size()) {}
  /// Of the sides from `first` on to the one before `end`.
  LoopLength(const boundary::BoundaryLoop& loop, std::size_t first, std::size_t end);

  [[nodiscard]] double whole() const { return starts_.back(); }
  /// Up to the start of a side, mm; the one behind the last gives the whole.
  [[nodiscard]] double upTo(std::size_t side) const { return starts_[side - first_]; }
  /// Up to a place on its sides.
  [[nodiscard]] double upTo(const boundary::LoopPlace& place) const;
  /// The place where `length` mm are behind; any multiple of the whole may be added.
  [[nodiscard]] boundary::LoopPlace placeAt(double length) const;

 private:
  std::size_t first_;
  std::vector<boundary::ArcLength> arcs_;
  std::vector<double> starts_;
};

/// Where a spoke ends between two corners: at the one side between them that starts at a split, or
/// `middle` mm along. None where there are several splits.
[[nodiscard]] std::optional<boundary::LoopPlace> spokeEnd(const LoopLength& lengths,
                                                          const std::vector<std::size_t>& splits,
                                                          double middle);

}  // namespace fairing::layout
