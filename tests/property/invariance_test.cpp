// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A fill is a matter of the hole alone: not of where it lies, how large it is, or which side comes
// first.
#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <numbers>

#include "core/fill/fill_hole.h"
#include "support/known_loops.h"
#include "support/random_splines.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using Eigen::Affine3d;
using Eigen::Vector3d;
using spline::BsplineSurface;

// Read by RapidCheck when the first property runs: always the same cases, few enough to be quick.
[[maybe_unused]] const int kConfigured = setenv("RC_PARAMS", "seed=20150101 max_success=12", 0);

constexpr double kSame = 1e-9;  // of the diagonal

double real(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

// Holes in wavy surfaces: with straight parameter lines or bowed ones, or between spline borders.
Sides someSides() {
  if (*rc::gen::arbitrary<bool>()) {
    Random random{static_cast<unsigned>(*rc::gen::inRange(0, 1000))};
    const auto u = randomKnots(random, 3, 2), v = randomKnots(random, 4, 2);
    return borderOf(randomSurface(random, u, v, 0.02));
  }
  auto corners = unevenQuadrilateral();
  for (auto& c : corners) c += Eigen::Vector2d(real(-0.15, 0.15), real(-0.15, 0.15));
  return sidesOf(waves(), corners, real(-0.08, 0.08));
}

BsplineSurface patchOf(const Sides& sides) {
  auto result = fillHole(finished(sides), {});
  RC_ASSERT(result.has_value());
  return result->patches[0];
}

Vector3d at(const BsplineSurface& patch, double s, double t) {
  return patch.evaluate(s * patch.u.last(), t * patch.v.last());
}

// Largest distance of patch a at (s, t) from patch b at `place(s, t)`, moved.
template <class Place>
double difference(const BsplineSurface& a,
                  const BsplineSurface& b,
                  const Place& place,
                  const Affine3d& motion = Affine3d::Identity()) {
  double worst = 0.0;
  for (const double s : {0.0, 0.21, 0.5, 0.83, 1.0})
    for (const double t : {0.0, 0.34, 0.5, 0.77, 1.0}) {
      const Eigen::Vector2d from = place(s, t);
      worst = std::max(worst, (at(a, s, t) - motion * at(b, from[0], from[1])).norm());
    }
  return worst;
}

Eigen::Vector2d samePlace(double s, double t) {
  return {s, t};
}

TEST(FillInvariance, MovesWithRigidMotions) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = someSides();
    const Vector3d axis = Vector3d(real(-1, 1), real(-1, 1), real(0.1, 1)).normalized();
    const Affine3d motion = Eigen::Translation3d(real(-10, 10), real(-10, 10), real(-10, 10)) *
                            Eigen::AngleAxisd(real(0.0, 2.0 * std::numbers::pi), axis);
    const double off = difference(patchOf(moved(sides, motion)), patchOf(sides), samePlace, motion);
    RC_ASSERT(off < kSame * finished(sides).diagonal);
  }));
}

TEST(FillInvariance, ScalesWithTheHole) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = someSides();
    const double scale = *rc::gen::element(1e-3, 0.1, 7.0, 1e4);
    const Affine3d scaling(Eigen::Scaling(scale));
    const double off =
        difference(patchOf(moved(sides, scaling)), patchOf(sides), samePlace, scaling);
    RC_ASSERT(off < kSame * scale * finished(sides).diagonal);
  }));
}

TEST(FillInvariance, DoesNotDependOnTheStart) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = someSides();
    const auto first = *rc::gen::inRange<std::size_t>(1, 4);
    // Starting one side on turns the domain by a quarter: (s, t) was (1 - t, s).
    const auto place = [first](double s, double t) {
      Eigen::Vector2d p(s, t);
      for (std::size_t k = 0; k < first; ++k) p = Eigen::Vector2d(1.0 - p[1], p[0]);
      return p;
    };
    const double off = difference(patchOf(startingAt(sides, first)), patchOf(sides), place);
    RC_ASSERT(off < kSame * finished(sides).diagonal);
  }));
}

TEST(FillInvariance, DoesNotDependOnTheDirection) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = someSides();
    // The last side run backwards comes first: u and v change places.
    const auto place = [](double s, double t) { return Eigen::Vector2d(t, s); };
    const double off = difference(patchOf(turnedRound(sides)), patchOf(sides), place);
    RC_ASSERT(off < kSame * finished(sides).diagonal);
  }));
}

TEST(FillInvariance, GuidanceScalesWithTheHole) {
  // Weights have no unit that depends on the size: the same lambda and gamma, the same shape.
  Random random{0};
  const auto knots = randomKnots(random, 3, 2);
  const Sides sides = borderOf(randomSurface(random, knots, knots, 0.02));
  const auto guided = [&](double size) {
    FillOptions options;
    options.maxRefinements = 0;
    options.guidance.lambda = 3.0;
    options.guidance.gamma = 20.0;
    options.guidance.reference = [size](const Vector3d& near) {
      const Vector3d p = near / size;
      const Vector3d normal = Vector3d(0.1, p[0], 1.0).normalized();
      return energy::GuidanceSample{normal, size * Vector3d(p[0], p[1], 0.1), 1.0, 1.0};
    };
    const auto loop = finished(moved(sides, Affine3d(Eigen::Scaling(size))));
    return fillHole(loop, options).value().patches[0];
  };
  const BsplineSurface once = guided(1.0);
  for (const double scale : {1e-3, 1e4}) {
    const Affine3d scaling(Eigen::Scaling(scale));
    EXPECT_LT(difference(guided(scale), once, samePlace, scaling),
              kSame * scale * finished(sides).diagonal);
  }
}

TEST(FillInvariance, ReportsTheSameDeviationsAtEveryScale) {
  EXPECT_TRUE(rc::check([] {
    const Sides sides = someSides();
    const double scale = *rc::gen::element(1e-3, 1e4);
    const auto a = fillHole(finished(sides), {});
    const auto b = fillHole(finished(moved(sides, Affine3d(Eigen::Scaling(scale)))), {});
    RC_ASSERT(a.has_value() && b.has_value());
    RC_ASSERT(std::abs(a->report.largestAngle - b->report.largestAngle) < 1e-6);
    RC_ASSERT(std::abs(scale * a->report.largestGap - b->report.largestGap) <
              1e-12 * scale * a->report.diagonal);
  }));
}

}  // namespace
}  // namespace fairing
