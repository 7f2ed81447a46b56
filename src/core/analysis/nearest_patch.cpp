// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/nearest_patch.h"

#include <algorithm>

namespace fairing::analysis {
namespace {

constexpr int kGrid = 12;
constexpr std::size_t kTried = 3;

struct Guess {
  double squaredDistance;
  int patch;
  double u, v;
};

}  // namespace

PatchFoot nearestPatch(const std::vector<spline::BsplineSurface>& patches,
                       const Eigen::Vector3d& point) {
  std::vector<Guess> guesses;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const spline::BsplineSurface& patch = patches[p];
    for (int i = 0; i <= kGrid; ++i)
      for (int j = 0; j <= kGrid; ++j) {
        const double u = patch.u.first() + (patch.u.last() - patch.u.first()) * i / kGrid;
        const double v = patch.v.first() + (patch.v.last() - patch.v.first()) * j / kGrid;
        guesses.push_back(
            {(patch.evaluate(u, v) - point).squaredNorm(), static_cast<int>(p), u, v});
      }
  }
  const std::size_t tried = std::min(kTried, guesses.size());
  std::partial_sort(
      guesses.begin(),
      guesses.begin() + static_cast<std::ptrdiff_t>(tried),
      guesses.end(),
      [](const Guess& a, const Guess& b) { return a.squaredDistance < b.squaredDistance; });
  PatchFoot best;
  for (std::size_t k = 0; k < tried; ++k) {
    const Guess& g = guesses[k];
    const SurfaceFoot foot =
        closestPoint(patches[static_cast<std::size_t>(g.patch)], point, g.u, g.v);
    if (k == 0 || foot.distance < best.foot.distance) best = {g.patch, foot};
  }
  return best;
}

}  // namespace fairing::analysis
