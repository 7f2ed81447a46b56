// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/nearest_patch.h"

#include <gmock/gmock.h>

#include <utility>

#include "support/known_surface.h"
#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::spline {
namespace {

using namespace ::fairing::testing;  // NOLINT: splines made of formulas
using Eigen::Vector3d;

// Two sheets of one surface side by side, [0, 1] and [1, 2] along x.
std::vector<spline::BsplineSurface> twoPatches() {
  const auto knots = spline::KnotVector::fromBreaks(3, {0.0, 0.4, 1.0});
  const auto shifted = [](double by) {
    return [by](double u, double v) { return waves()(u + by, v).point; };
  };
  return {interpolated(shifted(0.0), knots, knots), interpolated(shifted(1.0), knots, knots)};
}

TEST(NearestPatch, FindsTheFootOfAPointAboveAPatch) {
  const auto patches = twoPatches();
  for (int patch : {0, 1}) {
    for (const auto& [u, v] : {std::pair{0.2, 0.3}, std::pair{0.77, 0.9}, std::pair{0.5, 0.05}}) {
      const auto jet = patches[static_cast<std::size_t>(patch)].jet(u, v);
      const PatchFoot found = NearestPatch(patches).to(jet.point + 0.05 * normalOf(jet));
      EXPECT_EQ(found.patch, patch);
      EXPECT_NEAR(found.foot.u, u, 1e-8);
      EXPECT_NEAR(found.foot.v, v, 1e-8);
      EXPECT_NEAR(found.foot.distance, 0.05, 1e-10);
    }
  }
}

TEST(NearestPatch, StaysOnTheBorderForAPointBesideThePatches) {
  const auto patches = twoPatches();
  const Vector3d corner = patches[1].evaluate(1.0, 1.0);
  const PatchFoot found = NearestPatch(patches).to(corner + Vector3d(0.5, 0.5, 0.0));
  EXPECT_EQ(found.patch, 1);
  EXPECT_THAT(found.foot.jet.point, IsNear(corner, 0.1));
  EXPECT_LE(found.foot.u, 1.0);
  EXPECT_LE(found.foot.v, 1.0);
}

}  // namespace
}  // namespace fairing::spline
