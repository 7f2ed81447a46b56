// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/side_samples.h"

#include <algorithm>

namespace fairing::analysis {
namespace {

// Arc length over the parameter, by trapezoids.
class ArcLength {
 public:
  explicit ArcLength(const boundary::Ribbon& ribbon) {
    double speed = ribbon.curve(0.0).derivative.norm();
    for (int k = 1; k <= kSteps; ++k) {
      const double next = ribbon.curve(static_cast<double>(k) / kSteps).derivative.norm();
      lengths_.push_back(lengths_.back() + 0.5 * (speed + next) / kSteps);
      speed = next;
    }
  }
  /// The parameter where `share` of the length is behind.
  [[nodiscard]] double parameterAt(double share) const {
    const double length = share * lengths_.back();
    const auto above = std::upper_bound(lengths_.begin(), lengths_.end() - 1, length);
    const auto k = static_cast<std::size_t>(above - lengths_.begin());
    const double step = lengths_[k] - lengths_[k - 1];
    const double within = step > 0.0 ? (length - lengths_[k - 1]) / step : 0.5;
    return (static_cast<double>(k - 1) + within) / kSteps;
  }

 private:
  static constexpr int kSteps = 64;
  std::vector<double> lengths_{0.0};
};

}  // namespace

std::vector<SidePlace> sidePlaces(const boundary::Ribbon& ribbon, int inside, int corner) {
  const ArcLength length(ribbon);
  std::vector<SidePlace> places;
  const auto add = [&](double share, bool inCorner) {
    places.push_back({length.parameterAt(share), inCorner});
  };
  for (int k = 0; k < corner; ++k) add(kCornerZone * (k + 0.5) / corner, true);
  for (int k = 0; k < inside; ++k)
    add(kCornerZone + (1.0 - 2.0 * kCornerZone) * (k + 0.5) / inside, false);
  for (int k = 0; k < corner; ++k) add(1.0 - kCornerZone * (corner - k - 0.5) / corner, true);
  return places;
}

}  // namespace fairing::analysis
