// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/triangle_crossing.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/analysis/find_fold.h"
#include "core/analysis/patch_mesh.h"

namespace fairing::analysis {
namespace {

using Eigen::Vector3d;

/// A patch over [0, 1]^2 that interpolates a function of its two parameters at Greville abscissae
/// of a linear spline.
template <class Function>
spline::BsplineSurface surfaceOf(const Function& at, int spans = 40) {
  std::vector<double> breaks;
  for (int k = 0; k <= spans; ++k) breaks.push_back(static_cast<double>(k) / spans);
  const auto knots = spline::KnotVector::fromBreaks(1, breaks);
  spline::Poles poles((spans + 1) * (spans + 1), 3);
  for (int i = 0; i <= spans; ++i)
    for (int j = 0; j <= spans; ++j)
      poles.row(i * (spans + 1) + j) =
          at(breaks[static_cast<std::size_t>(i)], breaks[static_cast<std::size_t>(j)]).transpose();
  return {knots, knots, poles};
}

TEST(TriangleCrossing, IsWhereAnEdgePiercesATriangle) {
  const TriangleTree flat({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
  const TriangleTree steep({{{1, 1, -1}, {1, 1, 3}, {9, 9, 3}}, {{0, 1, 2}}});
  const auto found = flat.crossings(steep, Touches::DoNotCount);
  ASSERT_FALSE(found.empty());
  const auto isThere = [](const Vector3d& p) { return (p - Vector3d(1, 1, 0)).norm() < 1e-12; };
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), isThere));
  const TriangleTree beside({{{5, 5, -1}, {5, 5, 3}, {9, 9, 3}}, {{0, 1, 2}}});
  EXPECT_TRUE(flat.crossings(beside, Touches::Count).empty());
}

TEST(TriangleCrossing, LeavesOutTouchesWhereAsked) {
  const TriangleTree flat({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
  const TriangleTree standing({{{1, 1, 0}, {1, 1, 3}, {2, 1, 3}}, {{0, 1, 2}}});
  EXPECT_TRUE(flat.crossings(standing, Touches::DoNotCount).empty());
  EXPECT_FALSE(flat.crossings(standing, Touches::Count).empty());
}

TEST(TriangleCrossing, OfALoopedSheetIsItsDoubleLine) {
  // x = s^3 - s / 4, z = s^2 about s = 0 passes through x = 0, z = 1/4 twice.
  const auto looped = surfaceOf([](double u, double v) {
    const double s = 1.6 * u - 0.8;
    return Vector3d(s * s * s - 0.25 * s, v, s * s);
  });
  const auto size = sizeOf(TriangleTree(meshOf({looped})).ownCrossings());
  ASSERT_TRUE(size.has_value());
  EXPECT_NEAR(size->where.x(), 0.0, 5e-3);
  EXPECT_NEAR(size->where.z(), 0.25, 5e-3);
  EXPECT_NEAR(size->extent, 1.0, 0.05);
  const auto plain =
      surfaceOf([](double u, double v) { return Vector3d(u, v, std::sin(6.0 * u) * v); });
  EXPECT_TRUE(TriangleTree(meshOf({plain})).ownCrossings().empty());
  EXPECT_FALSE(findFold({plain}).has_value());
}

TEST(PatchMesh, NeighboursShareThePointsOfTheirSeam) {
  const auto left = surfaceOf([](double u, double v) { return Vector3d(u, v, u * v); });
  const auto right = surfaceOf([](double u, double v) { return Vector3d(1.0, v, v + u); });
  EXPECT_TRUE(TriangleTree(meshOf({left, right})).ownCrossings().empty());
}

TEST(FindFold, IsTheSmallerPartThatIsTurnedOver) {
  // The way across goes on to 1.0 and comes back to 0.8.
  const auto folded =
      surfaceOf([](double u, double v) { return Vector3d(v <= 0.8 ? v / 0.8 : 1.8 - v, u, 0.0); });
  const auto fold = findFold({folded});
  ASSERT_TRUE(fold.has_value());
  EXPECT_NEAR(fold->share, 0.2 / 1.2, 1e-6);
  EXPECT_NEAR(fold->where.x(), 0.9, 0.03);
}

}  // namespace
}  // namespace fairing::analysis
