// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/triharmonic.h"

#include <gtest/gtest.h>

#include "support/known_nets.h"

namespace fairing::uniform_patch {
namespace {

using namespace ::fairing::testing;  // NOLINT: nets

double largestDifference(const ControlNet& a, const ControlNet& b) {
  return (a.points - b.points).cwiseAbs().maxCoeff();
}

ControlNet triharmonic(const ControlNet& rings, const std::vector<FixedCurve>& curves = {}) {
  return *triharmonicNet(*constrain(rings, curves));
}

// Of any polynomial of degree 3 in either parameter the triple Laplacian vanishes.
TEST(Triharmonic, ReproducesCubicSurfacesFromTheirRings) {
  for (const auto& [n, m] : {std::pair(7, 7), std::pair(13, 13), std::pair(9, 16)}) {
    const ControlNet net = cubicNet(n, m);
    EXPECT_LT((evaluate(net, 4.3, 3.8) - cubicSurface(4.3, 3.8)).norm(), 1e-12);
    EXPECT_LT(largestDifference(triharmonic(disturbed(net, 1.0)), net), 1e-10) << n << " " << m;
  }
}

TEST(Triharmonic, KeepsTheRings) {
  const ControlNet net = waveNet(12, 10), patch = triharmonic(net);
  for (int i = 0; i < net.rows; ++i)
    for (int j = 0; j < net.columns; ++j)
      if (!net.isInner(i, j)) {
        EXPECT_EQ(patch.points.row(net.index(i, j)), net.points.row(net.index(i, j)));
      }
}

TEST(Triharmonic, IsTheLeastOfItsEnergy) {
  const ControlNet patch = triharmonic(waveNet(12, 10));
  for (unsigned seed = 0; seed < 5; ++seed)
    EXPECT_GT(triharmonicEnergy(disturbed(patch, 1e-3, seed)), triharmonicEnergy(patch));
}

TEST(Triharmonic, DoesNotMindAffineMaps) {
  Eigen::Matrix3d map;
  map << 2.0, 0.3, 0.0, -0.4, 1.0, 0.2, 0.1, 0.0, 5.0;
  ControlNet net = waveNet(11, 11), patch = triharmonic(net);
  net.points *= map.transpose();
  patch.points *= map.transpose();
  EXPECT_LT(largestDifference(triharmonic(net), patch), 1e-11);
}

TEST(Triharmonic, KeepsCurves) {
  const ControlNet net = waveNet(12, 12);
  const ControlNet patch = triharmonic(net, {{FixedCurve::Constant::U, 7.3}});
  for (const double v : {3.0, 4.4, 7.5, 11.9})
    EXPECT_LT((evaluate(patch, 7.3, v) - evaluate(net, 7.3, v)).norm(), 1e-12);
  EXPECT_GT(triharmonicEnergy(patch), triharmonicEnergy(triharmonic(net)));
}

}  // namespace
}  // namespace fairing::uniform_patch
