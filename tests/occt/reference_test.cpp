// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/reference.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeSphere.hxx>
#include <Geom_Plane.hxx>
#include <random>

#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;

TEST(Reference, FindsNearestPointsAndOutwardNormalsOfASphere) {
  const auto nearest = referenceOn(BRepPrimAPI_MakeSphere(10.0).Shape());
  ASSERT_TRUE(nearest.has_value());
  std::mt19937 random{0};
  std::uniform_real_distribution<double> uniform(-15.0, 15.0);
  for (int i = 0; i < 100; ++i) {
    const Vector3d p(uniform(random), uniform(random), uniform(random));
    if (p.norm() < 1.0) continue;
    const auto sample = (*nearest)(p);
    EXPECT_LT((sample.point - 10.0 * p.normalized()).norm(), 1e-7);
    EXPECT_LT((sample.normal - p.normalized()).norm(), 1e-7);
    EXPECT_EQ(sample.lambda, 1.0);
    EXPECT_EQ(sample.gamma, 1.0);
  }
}

TEST(Reference, StaysWithinTheTrimOfAFace) {
  const auto nearest =
      referenceOn(grid(new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), {0, 10}, {0, 10}, {}));
  ASSERT_TRUE(nearest.has_value());
  EXPECT_LT(((*nearest)({4, 5, 3}).point - Vector3d(4, 5, 0)).norm(), 1e-9);
  EXPECT_LT(((*nearest)({14, 5, 3}).point - Vector3d(10, 5, 0)).norm(), 1e-9);
  EXPECT_LT(((*nearest)({14, -5, 3}).point - Vector3d(10, 0, 0)).norm(), 1e-9);
}

TEST(Reference, TakesTheNearestOfSeveralFaces) {
  const auto nearest = referenceOn(box(10, 10, 10));
  ASSERT_TRUE(nearest.has_value());
  EXPECT_LT(((*nearest)({5, 5, 9}).normal - Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT(((*nearest)({5, 1, 5}).normal + Vector3d::UnitY()).norm(), 1e-12);
}

TEST(Reference, WeighsNothingBesideItsFaces) {
  const auto plane =
      referenceOn(grid(new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), {0, 5, 10}, {0, 10}, {}));
  ASSERT_TRUE(plane.has_value());
  for (const Vector3d& above : {Vector3d(4, 5, 3), Vector3d(5, 5, 3), Vector3d(10, 5, -1)})
    EXPECT_EQ((*plane)(above).gamma, 1.0);
  for (const Vector3d& beside : {Vector3d(10.1, 5, 3), Vector3d(14, 5, 0), Vector3d(5, -1, 1)}) {
    EXPECT_EQ((*plane)(beside).lambda, 0.0);
    EXPECT_EQ((*plane)(beside).gamma, 0.0);
  }
  // Beyond the edge where two faces meet nothing is missing.
  EXPECT_EQ((*referenceOn(box(10, 10, 10)))({12, 12, 5}).gamma, 1.0);
}

TEST(Reference, NeedsAFace) {
  EXPECT_FALSE(referenceOn(compound({})).has_value());
}

}  // namespace
}  // namespace fairing::occt
