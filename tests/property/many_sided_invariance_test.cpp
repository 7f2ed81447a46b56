// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Stars and o-grids are a matter of the hole alone, as one patch is (invariance_test.cpp).
#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "core/fill/fill_hole.h"
#include "core/spline/nearest_patch.h"
#include "support/many_sided_loops.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using Eigen::Affine3d;
using Eigen::Vector3d;
using Patches = std::vector<spline::BsplineSurface>;

// Of the diagonal.
constexpr double kSame = 1e-6;
constexpr double kSameRound = 1e-5;  // of a closed edge, moved; 6e-6 measured
constexpr double kSameStart = 3e-5;  // a patch has a knot where the edge starts; 1.1e-5 measured

double real(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

Sides someStar() {
  return polygonOn(waves(), *rc::gen::element(3, 5, 6), real(0.5, 0.9), real(0.0, 6.0));
}

Sides someRound() {
  return circleOn(waves(), real(0.5, 0.9), real(0.0, 6.0));
}

Patches filled(const Sides& sides) {
  auto result = fillHole(finished(sides), {});
  RC_ASSERT(result.has_value());
  RC_ASSERT(result->patches.size() > 1);
  return std::move(result->patches);
}

// Largest distance of points of the moved patches `a` from the patches `b`, as surfaces.
double difference(const Patches& a, const Patches& b, const Affine3d& motion) {
  double worst = 0.0;
  for (const auto& patch : a)
    for (int i = 0; i <= 6; ++i)
      for (int j = 0; j <= 6; ++j) {
        const Vector3d point = patch.evaluate(patch.u.last() * i / 6.0, patch.v.last() * j / 6.0);
        worst = std::max(worst, spline::NearestPatch(b).to(motion * point).foot.distance);
      }
  return worst;
}

void expectSame(const Sides& sides, const Sides& other, const Affine3d& motion, double same) {
  const double diagonal = finished(other).diagonal;
  RC_ASSERT(difference(filled(sides), filled(other), motion) < same * diagonal);
}

struct Kind {
  const char* name;
  Sides (*some)();
  double same;
};

class ManySided : public ::testing::TestWithParam<Kind> {};

TEST_P(ManySided, RigidMotionsMoveTheFill) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = GetParam().some();
    const Vector3d axis = Vector3d(real(-1, 1), real(-1, 1), real(0.1, 1)).normalized();
    const Affine3d motion = Eigen::Translation3d(real(-5, 5), real(-5, 5), real(-5, 5)) *
                            Eigen::AngleAxisd(real(0.0, 2.0 * std::numbers::pi), axis);
    expectSame(sides, moved(sides, motion), motion, GetParam().same);
  }));
}

TEST_P(ManySided, SizesScaleTheFill) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = GetParam().some();
    const Affine3d scaling(Eigen::Scaling(*rc::gen::element(1e-3, 0.1, 25.4, 1e4)));
    expectSame(sides, moved(sides, scaling), scaling, GetParam().same);
  }));
}

TEST_P(ManySided, TheDirectionOfTheLoopIsNoMatter) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = GetParam().some();
    expectSame(sides, turnedRound(sides), Affine3d::Identity(), GetParam().same);
  }));
}

INSTANTIATE_TEST_SUITE_P(FillInvariance,
                         ManySided,
                         ::testing::Values(Kind{"Star", someStar, kSame},
                                           Kind{"OGrid", someRound, kSameRound}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(FillInvariance, TheFirstSideOfAStarIsNoMatter) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = someStar();
    const auto first = *rc::gen::inRange<std::size_t>(1, sides.size());
    expectSame(sides, startingAt(sides, first), Affine3d::Identity(), kSame);
  }));
}

TEST(FillInvariance, WhereAClosedEdgeStartsIsNoMatter) {
  EXPECT_TRUE(rc::check([] {
    const double radius = real(0.5, 0.9);
    expectSame(circleOn(waves(), radius, real(0.0, 6.0)),
               circleOn(waves(), radius, real(0.0, 6.0)),
               Affine3d::Identity(),
               kSameStart);
  }));
}

}  // namespace
}  // namespace fairing
