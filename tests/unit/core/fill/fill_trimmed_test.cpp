// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/fill_trimmed.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/spline/closest_point.h"
#include "support/known_loops.h"
#include "support/matchers.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using boundary::BoundaryLoop;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTurn = 2.0 * std::numbers::pi;

Trace arc(const Vector2d& centre, double radius, double from, double to) {
  return [=](double t) {
    const double angle = from + t * (to - from);
    const Vector2d way(std::cos(angle), std::sin(angle));
    return TracePoint{centre + radius * way, radius * (to - from) * Vector2d(-way[1], way[0])};
  };
}

BoundaryLoop roundHole(const KnownSurface& surface, double radius = 0.6) {
  return finished({sideOn(surface, arc(Vector2d(0.1, 0.05), radius, 0.0, kTurn), 0)});
}

Sides polygon(const KnownSurface& surface, const std::vector<Vector2d>& corners) {
  Sides sides;
  for (std::size_t k = 0; k < corners.size(); ++k)
    sides.push_back(
        sideOn(surface, line(corners[k], corners[(k + 1) % corners.size()]), static_cast<int>(k)));
  return sides;
}

Sides angular(const KnownSurface& surface) {
  return polygon(surface, {{0, 0}, {1, 0.05}, {1.05, 0.5}, {0.5, 0.45}, {0.55, 1.0}, {0, 1.05}});
}

FillResult filled(const BoundaryLoop& loop, FillOptions options = {}) {
  options.layout = LayoutKind::Trimmed;
  auto result = fillHole(loop, options);
  EXPECT_TRUE(result.has_value()) << (result ? 0 : static_cast<int>(result.error().code));
  return result ? std::move(*result) : FillResult{};
}

FillOptions thinPlate() {
  FillOptions options;
  options.energy = EnergyKind::ThinPlate;
  return options;
}

// The largest distance of a surface's points (u, v) from the fill.
double distance(const KnownSurface& surface,
                const FillResult& fill,
                const std::vector<Vector2d>& places) {
  const spline::BsplineSurface& patch = fill.patches.front();
  double worst = 0.0;
  for (const Vector2d& place : places) {
    const Vector3d point = surface(place[0], place[1]).point;
    double least = std::numeric_limits<double>::infinity();
    for (const double s : {0.25, 0.5, 0.75})
      for (const double t : {0.25, 0.5, 0.75})
        least =
            std::min(least,
                     spline::closestPoint(patch,
                                          point,
                                          patch.u.first() + s * (patch.u.last() - patch.u.first()),
                                          patch.v.first() + t * (patch.v.last() - patch.v.first()))
                         .distance);
    worst = std::max(worst, least);
  }
  return worst;
}

std::vector<Vector2d> inTheRoundHole() {
  return {{0.1, 0.05}, {0.4, 0.05}, {-0.3, 0.1}, {0.2, -0.4}, {0.05, 0.5}};
}

struct Known {
  const char* name;
  std::function<BoundaryLoop()> loop;
};
class TrimmedHoles : public ::testing::TestWithParam<Known> {};

TEST_P(TrimmedHoles, AreFilledWithinTolerance) {
  const FillResult fill = filled(GetParam().loop());
  EXPECT_TRUE(fill.report.withinTolerance);
  EXPECT_EQ(fill.layout, LayoutKind::Trimmed);
  ASSERT_EQ(fill.patches.size(), 1U);
  EXPECT_LE(fill.summary.poles, 2400);
  EXPECT_TRUE(fill.report.notes.empty());
  for (const auto& side : fill.report.sides) EXPECT_FALSE(side.backwards);
}

TEST_P(TrimmedHoles, AreTrimmedByTheLoop) {
  const BoundaryLoop loop = GetParam().loop();
  const FillResult fill = filled(loop);
  ASSERT_EQ(fill.trims.size(), 1U);
  const auto& curves = fill.trims.front().curves;
  ASSERT_EQ(curves.size(), loop.sides.size());
  for (std::size_t k = 0; k < curves.size(); ++k) {
    EXPECT_EQ(curves[k].edge, loop.sides[k].edge);
    spline::BsplineCurve image{curves[k].inSpace.knots,
                               spline::Poles::Zero(curves[k].parameters.rows(), 3)};
    image.poles.leftCols<2>() = curves[k].parameters;
    for (const double t : {0.0, 0.3, 0.62, 1.0}) {
      const Vector3d point = loop.sides[k].ribbon.curve(t).point, at = image.evaluate(t);
      EXPECT_LT((curves[k].inSpace.evaluate(t) - point).norm(), 2e-7 * loop.diagonal);
      EXPECT_LT((fill.patches.front().evaluate(at[0], at[1]) - point).norm(),
                1.2e-6 * loop.diagonal);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    FillTrimmed,
    TrimmedHoles,
    ::testing::Values(
        Known{"RoundWaves", [] { return roundHole(waves()); }},
        Known{"RoundSaddle", [] { return roundHole(saddle(0.8)); }},
        Known{"RoundTorus", [] { return roundHole(torus(5.0, 2.0)); }},
        Known{"Triangle",
              [] { return finished(polygon(waves(), {{0, 0}, {1, 0.1}, {0.3, 0.9}})); }},
        Known{"Angular", [] { return finished(angular(waves())); }},
        Known{"SphereOctant",
              [] {
                const double right = std::numbers::pi / 2;
                const KnownSurface ball = sphere(3.0);
                // Three great circles; the third one over the pole of the parametrisation is
                // replaced by the parallel just below it.
                return finished(polygon(ball, {{0, 0}, {right, 0}, {right, 1.3}, {0, 1.3}}));
              }}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(FillTrimmed, AFlatHoleIsFilledFlat) {
  const FillResult fill = filled(roundHole(plane()));
  EXPECT_TRUE(fill.report.withinTolerance);
  for (const auto row : fill.patches.front().poles.rowwise()) EXPECT_NEAR(row[2], 0.0, 1e-9);
}

TEST(FillTrimmed, ACubicIsBiharmonicAndReproduced) {
  // Its mean slope over the disc is nothing, so that heights are measured along z.
  const KnownSurface cubic = heightField([](const Jet2& x, const Jet2& y) {
    return Jet2(0.1) * (x * x * x - Jet2(0.75) * x) + Jet2(0.2) * y * y - Jet2(0.1) * x * y;
  });
  const BoundaryLoop loop = finished({sideOn(cubic, arc(Vector2d::Zero(), 1.0, 0.0, kTurn), 0)});
  const FillResult fill = filled(loop, thinPlate());
  EXPECT_LT(distance(cubic, fill, {{0.0, 0.0}, {0.5, 0.1}, {-0.3, 0.6}, {0.2, -0.8}}), 1e-5);
  EXPECT_LT(fill.report.largestGap, 1e-7 * loop.diagonal);
}

TEST(FillTrimmed, TheSphereHasTheLeastGradientOfCurvature) {
  const KnownSurface ball =
      heightField([](const Jet2& x, const Jet2& y) { return sqrt(Jet2(1.0) - x * x - y * y); });
  const BoundaryLoop loop = roundHole(ball);
  FillOptions options;
  options.energy = EnergyKind::MeanCurvatureGradient;
  EXPECT_LT(distance(ball, filled(loop, options), inTheRoundHole()), 1e-5);
  // The plate does not know it.
  EXPECT_GT(distance(ball, filled(loop, thinPlate()), inTheRoundHole()), 1e-3);
}

TEST(FillTrimmed, G2SidesAreMetInCurvature) {
  for (const BoundaryLoop& given : {roundHole(waves()), roundHole(saddle(0.8))}) {
    BoundaryLoop loop = given;
    for (auto& side : loop.sides) side.continuity = Continuity::G2;
    const FillResult fill = filled(loop, thinPlate());
    EXPECT_TRUE(fill.report.withinTolerance);
    for (const auto& side : fill.report.sides) EXPECT_LT(side.curvature.max, 0.01);
  }
}

TEST(FillTrimmed, SidesWithoutSupportAreMetInPosition) {
  Sides sides = angular(waves());
  for (const std::size_t k : {1U, 3U}) {
    sides[k].continuity = Continuity::G0;
    sides[k].ribbon.support = {};
  }
  const FillResult fill = filled(finished(sides), thinPlate());
  EXPECT_TRUE(fill.report.withinTolerance);
  EXPECT_EQ(fill.report.sides[1].angle.count, 0);
}

TEST(FillTrimmed, PassesThroughPointsAndCurves) {
  const Vector3d peak(0.2, 0.1, 0.15);
  const auto ridge = [](double t) {
    const Vector2d at(-0.3 + 0.3 * t, -0.25 + 0.1 * t);
    return Vector3d(at[0], at[1], waves()(at[0], at[1]).point[2]);
  };
  FillOptions options = thinPlate();
  InnerConstraint point, curve;
  point.at = [peak](double) { return peak; };
  curve.at = ridge;
  curve.isPoint = false;
  options.through = {point, curve};
  const BoundaryLoop loop = roundHole(waves());
  const FillResult fill = filled(loop, options);
  EXPECT_TRUE(fill.report.withinTolerance);
  ASSERT_EQ(fill.report.inner.size(), 2U);
  for (const auto& inner : fill.report.inner) EXPECT_LT(inner.gap.max, 1e-6 * loop.diagonal);
  EXPECT_LT(spline::closestPoint(fill.patches[0], peak, 0.0, 0.0).distance, 1e-6 * loop.diagonal);
}

TEST(FillTrimmed, ATrimmedAwayPointIsReportedAsFarAsItIs) {
  FillOptions options = thinPlate();
  InnerConstraint beside;
  beside.at = [](double) { return Vector3d(0.9, 0.05, 0.0); };  // 0.2 outside the round hole
  options.through = {beside};
  const FillResult fill = filled(roundHole(plane()), options);
  EXPECT_NEAR(fill.report.largestInnerGap, 0.2, 0.01);
  EXPECT_FALSE(fill.report.withinTolerance);
  options.through[0].at = [](double) { return Vector3d(5.0, 0.0, 0.0); };
  options.layout = LayoutKind::Trimmed;
  EXPECT_THAT(fillHole(roundHole(plane()), options), FailsWith(ErrorCode::InnerConstraintOff));
}

TEST(FillTrimmed, GuidanceDrawsTheFaceToItsReference) {
  FillOptions options = thinPlate();
  options.guidance.gamma = 1e6;
  options.guidance.reference = [](const Vector3d& near) {
    const double r2 = (near.head<2>() - Vector2d(0.1, 0.05)).squaredNorm() / 0.36;
    const double bump = r2 < 1.0 ? 0.1 * std::pow(1.0 - r2, 3.0) : 0.0;
    return energy::GuidanceSample{Vector3d::UnitZ(), {near[0], near[1], bump}, 1.0, 1.0};
  };
  const FillResult fill = filled(roundHole(plane()), options);
  EXPECT_TRUE(fill.report.withinTolerance);
  const Vector3d middle =
      spline::closestPoint(fill.patches[0], Vector3d(0.1, 0.05, 0.1), 0.0, 0.0).jet.point;
  EXPECT_NEAR(middle[2], 0.1, 0.01);
}

TEST(FillTrimmed, SaysHowSteepTheSupportsAre) {
  // The end of a pipe: its supports stand upright on every plane that sees the loop.
  const FillResult fill = filled(
      finished({sideOn(
          cylinder(1.0),
          [](double t) { return TracePoint{Vector2d(kTurn * t, 0.0), Vector2d(kTurn, 0.0)}; },
          0)}),
      thinPlate());
  ASSERT_FALSE(fill.report.notes.empty());
  EXPECT_EQ(fill.report.notes[0].code, analysis::NoteCode::LoopUnfit);
  EXPECT_NEAR(fill.report.notes[0].value, 90.0, 0.1);
  EXPECT_FALSE(fill.report.withinTolerance);
}

TEST(FillTrimmed, RefusesALoopThatNoPlaneSeesWithoutCrossings) {
  const Trace eight = [](double t) {
    return TracePoint{
        Vector2d(std::sin(kTurn * t), 0.3 * std::sin(2.0 * kTurn * t) + 0.2 * std::cos(kTurn * t)),
        kTurn * Vector2d(std::cos(kTurn * t),
                         0.6 * std::cos(2.0 * kTurn * t) - 0.2 * std::sin(kTurn * t))};
  };
  FillOptions options = thinPlate();
  options.layout = LayoutKind::Trimmed;
  const auto result = fillHole(finished({sideOn(plane(), eight, 0)}), options);
  ASSERT_THAT(result, FailsWith(ErrorCode::LayoutUnfit));
  EXPECT_EQ(result.error().detail, "trimmed");
}

}  // namespace
}  // namespace fairing
