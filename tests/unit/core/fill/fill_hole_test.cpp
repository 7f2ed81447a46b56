// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/fill_hole.h"

#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "support/known_loops.h"
#include "support/matchers.h"
#include "support/measure.h"
#include "support/random_splines.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using boundary::BoundaryLoop;
using Eigen::Vector3d;
using spline::BsplineSurface;
using spline::KnotVector;

FillResult filled(const BoundaryLoop& loop, const FillOptions& options = {}) {
  auto result = fillHole(loop, options);
  EXPECT_TRUE(result.has_value());
  return result ? std::move(*result) : FillResult{};
}

struct KnownHole {
  const char* name;
  std::function<BoundaryLoop()> loop;
};

BsplineSurface roughSpline() {
  Random random{0};
  const KnotVector u = randomKnots(random, 3, 3), v = randomKnots(random, 4, 2);
  return randomSurface(random, u, v, 0.03);
}

class KnownHoles : public ::testing::TestWithParam<KnownHole> {
 protected:
  BoundaryLoop loop_ = GetParam().loop();
  FillResult fill_ = filled(loop_);
};

TEST_P(KnownHoles, AreFilledWithinTolerance) {
  EXPECT_TRUE(fill_.report.withinTolerance);
  const QuadDeviation d = deviationOf(loop_, fill_.patches[0]);
  // A tenth more than the limits: our places are not the report's, the peaks lie between both.
  EXPECT_LT(d.gap, 1.1e-6 * loop_.diagonal);
  EXPECT_LT(d.angle, 1.1 * 0.02);
  EXPECT_LT(d.cornerAngle, 1.1 * 0.05);
}

TEST_P(KnownHoles, AreReportedAsWeMeasureThem) {
  const QuadDeviation d = deviationOf(loop_, fill_.patches[0]);
  // The report's 81 places against our 137: worst values agree to a part, or are both rounding.
  EXPECT_NEAR(fill_.report.largestAngle, d.angle, 0.2 * d.angle + 1e-6);
  EXPECT_NEAR(fill_.report.largestGap, d.gap, 0.5 * d.gap + 1e-12 * loop_.diagonal);
}

TEST_P(KnownHoles, LeaveEverySideForwards) {
  for (const auto& side : fill_.report.sides) EXPECT_FALSE(side.backwards);
}

INSTANTIATE_TEST_SUITE_P(
    FillHole,
    KnownHoles,
    ::testing::Values(
        KnownHole{"Waves", [] { return loopOf(waves(), unitSquare()); }},
        KnownHole{"WavesOblique", [] { return loopOf(waves(), unevenQuadrilateral(), 0.08); }},
        KnownHole{"Saddle", [] { return loopOf(saddle(0.5), rectangle(-0.5, 0.5, -0.5, 0.5)); }},
        KnownHole{"SteepSaddle",
                  [] { return loopOf(saddle(2.0), rectangle(-0.5, 0.5, -0.5, 0.5)); }},
        KnownHole{"Torus", [] { return loopOf(torus(5.0, 2.0), rectangle(0.0, 0.8, -0.5, 0.9)); }},
        KnownHole{"Sphere", [] { return loopOf(sphere(3.0), rectangle(0.0, 1.0, -0.5, 0.6)); }},
        KnownHole{"Cylinder", [] { return loopOf(cylinder(2.0), rectangle(0.0, 1.2, 0.0, 3.0)); }},
        KnownHole{"Long", [] { return loopOf(cylinder(1.0), rectangle(0.0, 1.0, 0.0, 8.0)); }},
        KnownHole{"Spline", [] { return finished(borderOf(roughSpline())); }}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(FillHole, AFlatHoleIsFilledFlat) {
  const FillResult fill = filled(loopOf(plane(), unevenQuadrilateral()));
  EXPECT_TRUE(fill.report.withinTolerance);
  EXPECT_LT(distanceFromPlane(fill.patches[0], Vector3d::Zero(), Vector3d::UnitZ()), 1e-12);
}

TEST(FillHole, PolynomialSidesAreMetToRounding) {
  const FillResult fill = filled(finished(borderOf(roughSpline())));
  EXPECT_LT(fill.report.largestGap, 1e-13);
}

TEST(FillHole, MembraneMeetsTheSidesToo) {
  FillOptions options;
  options.energy = EnergyKind::Membrane;
  EXPECT_TRUE(filled(loopOf(waves(), unitSquare()), options).report.withinTolerance);
}

TEST(FillHole, EveryDegreeMeetsTheSides) {
  for (const int degree : {4, 5, 6, 7}) {
    FillOptions options;
    options.degree = degree;
    const FillResult fill = filled(loopOf(waves(), unitSquare()), options);
    EXPECT_EQ(fill.patches[0].u.degree(), degree);
    EXPECT_TRUE(fill.report.withinTolerance) << "degree " << degree;
  }
}

TEST(FillHole, ATighterToleranceIsMet) {
  FillOptions options;
  options.tolerance.angle = 1e-3;
  options.tolerance.cornerAngle = 2e-3;
  options.tolerance.relativeGap = 1e-8;
  const BoundaryLoop loop = loopOf(waves(), unitSquare());
  const FillResult fill = filled(loop, options);
  EXPECT_TRUE(fill.report.withinTolerance);
  EXPECT_LT(deviationOf(loop, fill.patches[0]).angle, 1.1e-3);
}

TEST(FillHole, G0SidesWithoutSupportAreMetInPosition) {
  Sides sides = sidesOf(waves(), unitSquare());
  for (auto& side : sides) {
    side.continuity = Continuity::G0;
    side.ribbon.support = {};
  }
  const BoundaryLoop loop = finished(sides);
  const FillResult fill = filled(loop);
  EXPECT_TRUE(fill.report.withinTolerance);
  EXPECT_LT(deviationOf(loop, fill.patches[0]).gap, 1.1e-6 * loop.diagonal);
  EXPECT_EQ(fill.report.sides[0].angle.count, 0);
}

TEST(FillHole, MixedSidesAreMetAsEachAsks) {
  Sides sides = sidesOf(waves(), unitSquare());
  sides[1].continuity = Continuity::G0;
  sides[3].continuity = Continuity::G0;
  sides[3].ribbon.support = {};
  const BoundaryLoop loop = finished(sides);
  const FillResult fill = filled(loop);
  EXPECT_TRUE(fill.report.withinTolerance);
  for (const std::size_t side : {0U, 2U})
    EXPECT_LT(deviationOf(loop, fill.patches[0], side).angle, 1.1 * 0.02);
}

TEST(FillHole, IncompatibleTwistsAreReportedAndTheErrorStaysInTheCorner) {
  const BoundaryLoop loop = finished(incompatibleTwists(0.5));
  const FillResult fill = filled(loop);
  for (const auto& corner : fill.report.corners) {
    EXPECT_NEAR(corner.twistMismatch, 0.5 * 180.0 / std::numbers::pi, 1e-6);
    EXPECT_FALSE(corner.twistsAgree);
  }
  for (std::size_t side = 0; side < 4; ++side)
    EXPECT_LT(deviationOf(loop, fill.patches[0], side, 0.1, 0.9).angle, 0.02);
}

TEST(FillHole, KnotsAreGradedTowardsIncompatibleCorners) {
  const auto breaks = filled(finished(incompatibleTwists(0.5))).patches[0].u.breaks();
  ASSERT_GE(breaks.size(), 5U);
  const std::size_t last = breaks.size() - 1;
  // Halved again and again: 1, 1, 2, 4, ... times the end span.
  EXPECT_LT(breaks[1], 0.1 * breaks[last]);
  EXPECT_LT(breaks[last] - breaks[last - 1], 0.1 * breaks[last]);
  EXPECT_NEAR(breaks[2] - breaks[1], breaks[1], 1e-12);
  EXPECT_NEAR(breaks[3] - breaks[2], 2.0 * breaks[1], 1e-12);
}

TEST(FillHole, NormalsThatDisagreeAtACornerAreReportedAndDoNotFail) {
  Sides sides = sidesOf(plane(), unitSquare());
  sides[1].ribbon.support = [flat = sides[1].ribbon.support](double t) {
    auto s = flat(t);
    s.normal = Eigen::AngleAxisd(0.1, Vector3d::UnitY()) * s.normal;
    return s;
  };
  const FillResult fill = filled(finished(sides));
  EXPECT_NEAR(fill.report.corners[0].normalMismatch, 0.1 * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_FALSE(fill.report.corners[0].normalsAgree);
  EXPECT_TRUE(fill.report.corners[2].normalsAgree);
  EXPECT_FALSE(fill.report.withinTolerance);
}

TEST(FillHole, AResultThatMayNotBeRefinedIsMarked) {
  FillOptions options;
  options.maxRefinements = 0;
  options.tolerance.angle = options.tolerance.cornerAngle = 1e-6;
  const FillResult fill = filled(loopOf(waves(), unitSquare()), options);
  EXPECT_EQ(fill.summary.solves, 1);
  EXPECT_FALSE(fill.report.withinTolerance);
  EXPECT_GT(fill.report.largestAngle, options.tolerance.angle);
}

TEST(FillHole, StaysWithinTheLimitOfPoles) {
  FillOptions options;
  options.maxPoles = 100;
  options.tolerance.angle = options.tolerance.cornerAngle = 1e-7;
  const FillResult fill = filled(loopOf(waves(), unitSquare()), options);
  EXPECT_LE(fill.summary.poles, 100);
  EXPECT_FALSE(fill.report.withinTolerance);
}

TEST(FillHole, StaysWithinTheLimitOfPolesFromTheFirstLayoutOn) {
  // A fit that would take thousands of control points a side.
  FillOptions options;
  options.maxPoles = 400;
  options.tolerance.relativeGap = 1e-14;
  const FillResult fill = filled(loopOf(waves(), rectangle(0.0, 20.0, 0.0, 20.0)), options);
  EXPECT_LE(fill.summary.poles, 400);
  EXPECT_FALSE(fill.report.withinTolerance);
}

TEST(FillHole, ABicubicBezierPatchIsEnoughForASaddle) {
  // All inner control points belong to the corners: the sides have no rows of their own.
  FillOptions options;
  options.degree = 3;
  options.energy = EnergyKind::ThinPlate;
  const FillResult fill = filled(loopOf(saddle(2.0), rectangle(-0.5, 0.5, -0.5, 0.5)), options);
  EXPECT_EQ(fill.summary.poles, 16);
  EXPECT_LT(fill.report.largestAngle, 1e-10);
}

TEST(FillHole, SummaryCountsWhatIsThere) {
  const FillResult fill = filled(loopOf(waves(), unitSquare()));
  EXPECT_EQ(fill.summary.poles, fill.patches[0].poles.rows());
  const int nu = fill.patches[0].u.poleCount(), nv = fill.patches[0].v.poleCount();
  EXPECT_EQ(fill.summary.unknowns + fill.summary.constraints, 3 * (nu - 2) * (nv - 2));
  EXPECT_GT(fill.summary.energy, 0.0);
  EXPECT_GE(fill.summary.totalTime, fill.summary.solveTime);
}

TEST(FillHole, NormalsPointAsTheSupportsDo) {
  const Sides sides = sidesOf(waves(), unitSquare());
  for (const Sides& way : {sides, turnedRound(sides)}) {
    const BoundaryLoop loop = finished(way);
    const FillResult fill = filled(loop);
    EXPECT_FALSE(fill.reversed[0]);
    EXPECT_FALSE(fill.report.reversed);
    const Vector3d normal = fill.patches[0].jet(0.01, 0.0).normalVector();
    EXPECT_GT(normal.dot(loop.sides[0].ribbon.support(0.01).normal), 0.0);
  }
}

TEST(FillHole, AnAbortAskedForBeforehandCancels) {
  Progress progress;
  progress.requestAbort();
  EXPECT_THAT(fillHole(loopOf(waves(), unitSquare()), {}, &progress),
              FailsWith(ErrorCode::Cancelled));
}

TEST(FillHole, AnAbortBetweenTwoLooksAtTheGuideCancels) {
  Progress progress;
  FillOptions options;
  options.guidance.gamma = 1.0;
  options.guidance.reference = [&](const Vector3d& near) {
    progress.requestAbort();
    return energy::GuidanceSample{Vector3d::UnitZ(), {near.x(), near.y(), 1.0}, 1.0, 1.0};
  };
  EXPECT_THAT(fillHole(loopOf(waves(), unitSquare()), options, &progress),
              FailsWith(ErrorCode::Cancelled));
}

TEST(FillHole, AnAbortInTheMiddleCancels) {
  // The first solve asks for the abort by way of a ribbon; a tolerance never met keeps it going.
  Progress progress;
  Sides sides = sidesOf(waves(), unitSquare());
  BoundaryLoop loop = finished(sides);
  loop.sides[0].ribbon.support = [given = loop.sides[0].ribbon.support, &progress](double t) {
    progress.requestAbort();
    return given(t);
  };
  FillOptions options;
  options.tolerance.angle = options.tolerance.cornerAngle = 1e-9;
  EXPECT_THAT(fillHole(loop, options, &progress), FailsWith(ErrorCode::Cancelled));
}

TEST(FillHole, ProgressGrowsToAtMostOne) {
  Progress progress;
  ASSERT_TRUE(fillHole(loopOf(waves(), unitSquare()), {}, &progress).has_value());
  EXPECT_GT(progress.fraction(), 0.0);
  EXPECT_LE(progress.fraction(), 1.0);
}

TEST(FillHole, BadOptionsAreRefused) {
  FillOptions options;
  options.tolerance.angle = -1.0;
  EXPECT_THAT(fillHole(loopOf(plane(), unitSquare()), options),
              FailsWith(ErrorCode::AngleNotPositive));
}

TEST(FillHole, ThreeSidesInAPlaneAreSpannedByAFlatStar) {
  const Eigen::Vector2d a(0.0, 0.0), b(1.0, 0.0), c(0.0, 1.0);
  const FillResult fill = filled(finished({sideOn(plane(), line(a, b), 0),
                                           sideOn(plane(), line(b, c), 1),
                                           sideOn(plane(), line(c, a), 2)}));
  EXPECT_EQ(fill.layout, LayoutKind::Star);
  EXPECT_EQ(fill.patches.size(), 3U);
  for (const auto& patch : fill.patches) EXPECT_LT(patch.poles.col(2).cwiseAbs().maxCoeff(), 1e-10);
}

// The octant of a sphere: three corners of 90 degrees.
TEST(FillHole, TheOctantOfASphereIsASphere) {
  const KnownSurface ball =
      heightField([](const Jet2& x, const Jet2& y) { return sqrt(Jet2(4.0) - x * x - y * y); });
  const Eigen::Vector2d a(-0.9, -0.6), b(1.0, -0.5), c(0.1, 1.1);
  const FillResult fill = filled(finished(
      {sideOn(ball, line(a, b), 0), sideOn(ball, line(b, c), 1), sideOn(ball, line(c, a), 2)}));
  EXPECT_TRUE(fill.report.withinTolerance);
  EXPECT_LT(fill.report.largestSeamAngle, 0.02);
  EXPECT_LT(fill.report.largestSeamGap, 1e-14);
  double farthest = 0.0;
  for (const auto& patch : fill.patches)
    for (const double u : {0.1, 0.5, 0.9})
      for (const double v : {0.2, 0.5, 0.8})
        farthest =
            std::max(farthest,
                     std::abs(patch.evaluate(u * patch.u.last(), v * patch.v.last()).norm() - 2.0));
  EXPECT_LT(farthest, 1e-5 * fill.report.diagonal);
}

// A round hole in a wavy surface: no corner anywhere, four patches round a fifth.
TEST(FillHole, ARoundHoleIsSpannedByAnOGrid) {
  const auto circle = [](double t) {
    const double angle = 2.0 * std::numbers::pi * t;
    return TracePoint{{std::cos(angle), std::sin(angle)},
                      2.0 * std::numbers::pi * Eigen::Vector2d(-std::sin(angle), std::cos(angle))};
  };
  const FillResult fill = filled(finished({sideOn(waves(), circle, 0)}));
  EXPECT_EQ(fill.layout, LayoutKind::OGrid);
  EXPECT_TRUE(fill.report.withinTolerance);
  EXPECT_EQ(fill.report.seams.size(), 8U);
}

TEST(FillHole, NormalsThatAreNotNumbersFailAndDoNotCrash) {
  BoundaryLoop loop = loopOf(waves(), unitSquare());
  loop.sides[2].ribbon.support = [](double) {
    boundary::SupportSample s;
    s.normal.setConstant(std::numeric_limits<double>::quiet_NaN());
    return s;
  };
  const auto result = fillHole(loop, {});
  ASSERT_FALSE(result.has_value());
  EXPECT_THAT(result.error().code,
              ::testing::AnyOf(ErrorCode::NotFinite, ErrorCode::SupportNormalSingular));
  EXPECT_EQ(result.error().edge, 3);
}

TEST(FillHole, ACurveThatIsNotANumberFailsAndDoesNotCrash) {
  BoundaryLoop loop = loopOf(waves(), unitSquare());
  loop.sides[1].ribbon.curve = [given = loop.sides[1].ribbon.curve](double t) {
    auto c = given(t);
    if (t > 0.4 && t < 0.6) c.point[2] = std::numeric_limits<double>::quiet_NaN();
    return c;
  };
  EXPECT_THAT(fillHole(loop, {}), FailsWith(ErrorCode::NotFinite));
}

// The height of the patch over the middle of its domain.
double middle(const FillResult& fill) {
  const BsplineSurface& p = fill.patches[0];
  return p.evaluate(0.5 * p.u.last(), 0.5 * p.v.last())[2];
}

TEST(Guidance, AReferencePullsTheSurfaceToItself) {
  const BoundaryLoop loop = loopOf(plane(), unitSquare());
  FillOptions options;
  options.energy = EnergyKind::ThinPlate;
  options.guidance.reference = [](const Vector3d& near) {
    energy::GuidanceSample s;
    s.point = Vector3d(near[0], near[1], 0.1);
    s.normal = Vector3d::UnitZ();
    s.lambda = s.gamma = 1.0;
    return s;
  };
  double before = middle(filled(loop, options));
  EXPECT_NEAR(before, 0.0, 1e-12);  // gamma = 0: no pull
  for (const double gamma : {1e2, 1e3, 1e4, 1e5}) {
    options.guidance.gamma = gamma;
    const FillResult fill = filled(loop, options);
    EXPECT_TRUE(fill.report.withinTolerance);  // the sides come first, whatever the weight
    EXPECT_GT(middle(fill), before);
    before = middle(fill);
  }
  EXPECT_GT(before, 0.08);
}

TEST(Guidance, AHandleTurnsTheNormalNearIt) {
  const BoundaryLoop loop = loopOf(plane(), unitSquare());
  const Vector3d wished = Vector3d(0.3, 0.0, 1.0).normalized();
  const auto angleAt = [&](const FillResult& fill) {
    const BsplineSurface& p = fill.patches[0];
    const Vector3d n = p.jet(0.5 * p.u.last(), 0.5 * p.v.last()).normalVector().normalized();
    return std::acos(std::min(1.0, std::abs(n.dot(wished)))) * 180.0 / std::numbers::pi;
  };
  FillOptions options;
  options.guidance.handles = {{Vector3d(0.5, 0.5, 0.0), wished, 1.0, 0.3}};
  double before = angleAt(filled(loop, options));
  EXPECT_NEAR(before, 16.7, 0.1);  // atan 0.3: lambda = 0 leaves the patch flat
  for (const double lambda : {1e2, 1e3, 1e4}) {
    options.guidance.lambda = lambda;
    const FillResult fill = filled(loop, options);
    EXPECT_TRUE(fill.report.withinTolerance);
    EXPECT_LT(angleAt(fill), before);
    before = angleAt(fill);
  }
  EXPECT_LT(before, 12.0);
}

}  // namespace
}  // namespace fairing
