// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/nearest_patch.h"

#include <algorithm>
#include <array>
#include <limits>

namespace fairing::spline {
namespace {

constexpr int kGrid = 12;
constexpr std::size_t kTried = 3;

}  // namespace

NearestPatch::NearestPatch(const std::vector<BsplineSurface>& patches) : patches_(patches) {
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const BsplineSurface& patch = patches[p];
    for (int i = 0; i <= kGrid; ++i)
      for (int j = 0; j <= kGrid; ++j) {
        const double u = patch.u.at(double(i) / kGrid), v = patch.v.at(double(j) / kGrid);
        grid_.push_back({patch.evaluate(u, v), static_cast<int>(p), u, v});
      }
  }
}

PatchFoot NearestPatch::to(const Eigen::Vector3d& point) const {
  std::array<Place, kTried> guesses;
  const auto end = std::partial_sort_copy(grid_.begin(),
                                          grid_.end(),
                                          guesses.begin(),
                                          guesses.end(),
                                          [&](const Place& a, const Place& b) {
                                            return (a.point - point).squaredNorm() <
                                                   (b.point - point).squaredNorm();
                                          });
  PatchFoot best;
  best.foot.distance = std::numeric_limits<double>::infinity();
  for (auto guess = guesses.begin(); guess != end; ++guess) {
    const SurfaceFoot foot =
        closestPoint(patches_[static_cast<std::size_t>(guess->patch)], point, guess->u, guess->v);
    if (foot.distance < best.foot.distance) best = {guess->patch, foot};
  }
  return best;
}

}  // namespace fairing::spline
