// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A trimmed face is a matter of the hole alone, as far as the tolerances let it be seen.
#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "core/fill/fill_hole.h"
#include "core/spline/closest_point.h"
#include "support/known_loops.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using Eigen::Affine3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

double real(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

Sides someSides() {
  std::vector<Vector2d> corners{{0, 0}, {1.3, 0.1}, {1.25, 0.5}, {0.6, 0.45}, {0.5, 0.9}, {0, 1}};
  for (Vector2d& corner : corners) corner += Vector2d(real(-0.1, 0.1), real(-0.1, 0.1));
  Sides sides;
  for (std::size_t k = 0; k < corners.size(); ++k)
    sides.push_back(sideOn(
        waves(), bow(corners[k], corners[(k + 1) % corners.size()], 0.04), static_cast<int>(k)));
  return sides;
}

spline::BsplineSurface faceOf(const Sides& sides) {
  FillOptions options;
  options.layout = LayoutKind::Trimmed;
  options.energy = EnergyKind::ThinPlate;
  auto result = fillHole(finished(sides), options);
  RC_ASSERT(result.has_value());
  RC_ASSERT(result->report.withinTolerance);
  return result->patches[0];
}

// Points of the waves inside every hole of someSides(): where the two faces are compared.
double difference(const spline::BsplineSurface& a,
                  const spline::BsplineSurface& b,
                  const Affine3d& motion = Affine3d::Identity()) {
  const auto foot = [](const spline::BsplineSurface& face, const Vector3d& near) {
    return spline::closestPoint(face,
                                near,
                                0.5 * (face.u.first() + face.u.last()),
                                0.5 * (face.v.first() + face.v.last()))
        .jet.point;
  };
  double worst = 0.0;
  for (const Vector2d& place : {Vector2d(0.3, 0.3), Vector2d(0.8, 0.25), Vector2d(0.25, 0.6)}) {
    const Vector3d on = motion * foot(b, waves()(place[0], place[1]).point);
    worst = std::max(worst, (foot(a, on) - on).norm());
  }
  return worst;
}

// Faces differ inside by what their border may differ by: 0.02 degrees of slope over a hole of
// about 1.
constexpr double kSame = 1e-4;

TEST(TrimmedInvariance, MovesAndScalesWithTheHole) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = someSides();
    const double scale = *rc::gen::element(1.0, 1e-3, 1e4);
    const Vector3d axis = Vector3d(real(-1, 1), real(-1, 1), real(0.1, 1)).normalized();
    const Affine3d motion = Eigen::Translation3d(real(-10, 10), real(-10, 10), real(-10, 10)) *
                            Eigen::AngleAxisd(real(0.0, 2.0 * std::numbers::pi), axis) *
                            Eigen::Scaling(scale);
    RC_ASSERT(difference(faceOf(moved(sides, motion)), faceOf(sides), motion) < kSame * scale);
  }));
}

TEST(TrimmedInvariance, DoesNotDependOnStartAndDirection) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = someSides();
    const auto first = *rc::gen::inRange<std::size_t>(1, 6);
    const spline::BsplineSurface face = faceOf(sides);
    RC_ASSERT(difference(faceOf(startingAt(sides, first)), face) < kSame);
    RC_ASSERT(difference(faceOf(turnedRound(sides)), face) < kSame);
  }));
}

}  // namespace
}  // namespace fairing
