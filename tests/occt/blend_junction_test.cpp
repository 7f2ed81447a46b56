// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <Eigen/Geometry>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "occt/blends.h"
#include "occt/from_occt.h"
#include "occt/shapes.h"
#include "text/error_text.h"
#include "text/report_text.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;

constexpr double kRound = 2.0 * std::numbers::pi;

/// A pipe that comes in along an axis and ends `gap` mm before the origin, 8 mm long. Its rim
/// starts where `start` says, an angle about the axis.
struct Pipe {
  gp_Dir axis;
  double radius = 5.0, gap = 14.0, start = 0.0;

  [[nodiscard]] Handle(Geom_Surface) surface() const {
    return new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, 0), axis), radius);
  }
  [[nodiscard]] TopoDS_Shape face() const {
    return grid(surface(), {start, start + kRound}, {gap, gap + 8.0}, {}, Joint::Loose);
  }
  /// The point of the rim half way round.
  [[nodiscard]] Vector3d rim() const {
    return fromOcct(surface()->Value(start + 0.5 * kRound, gap));
  }
};

/// Three pipes of different radius in directions that lie in no plane.
std::vector<Pipe> skewPipes() {
  return {{gp_Dir(1, 0.1, 0.2), 5.0, 14.0, 0.3},
          {gp_Dir(-0.5, 0.9, -0.1), 4.5, 15.0, 1.0},
          {gp_Dir(-0.4, -0.9, 0.15), 4.0, 13.0, 2.0}};
}

TopoDS_Shape shapeOf(const std::vector<Pipe>& pipes) {
  std::vector<TopoDS_Shape> faces;
  for (const Pipe& pipe : pipes) faces.push_back(pipe.face());
  return compound(faces);
}

BlendPicks rimsOf(const TopoDS_Shape& shape,
                  const std::vector<Pipe>& pipes,
                  Continuity continuity = Continuity::G1) {
  std::vector<Vector3d> points;
  for (const Pipe& pipe : pipes) points.push_back(pipe.rim());
  const std::vector<int> edges = edgesNear(ShapeIndex(shape), points);
  return {
      .from = {edges.front()}, .to = {edges.begin() + 1, edges.end()}, .continuity = continuity};
}

ShapeFill joined(const std::vector<Pipe>& pipes) {
  const TopoDS_Shape shape = shapeOf(pipes);
  return blended(shape, rimsOf(shape, pipes));
}

TEST(BlendJunction, JoinsThreeSkewPipesTangentially) {
  const ShapeFill blend = joined(skewPipes());
  EXPECT_EQ(blend.fill.layout, LayoutKind::Junction);
  EXPECT_EQ(blend.fill.patches.size(), 12U);
  expectWithin(blend);
}

TEST(BlendJunction, MeetsCurvatureWhereAsked) {
  const TopoDS_Shape shape = shapeOf(skewPipes());
  BlendOptions options;
  options.fill.maxPoles = 1250;  // a round less, for a test that does not last
  const auto blend =
      tryBlend(shape, rimsOf(shape, skewPipes(), Continuity::G2), ResultMode::Patches, options);
  ASSERT_TRUE(blend.has_value());
  EXPECT_LT(blend->fill.report.largestCurvature, 0.05);
  EXPECT_LT(blend->fill.report.largestAngle, 0.02);
}

// The gradient of the mean curvature, which is made small, vanishes on a sphere.
TEST(BlendJunction, OfThreeCapsOfASphereIsThatSphere) {
  const double radius = 10.0;
  std::vector<TopoDS_Shape> caps;
  std::vector<Vector3d> rims;
  for (int k = 0; k < 3; ++k) {
    const double turn = kRound * k / 3.0;
    const gp_Ax3 frame(gp_Pnt(0, 0, 0), gp_Dir(std::cos(turn), std::sin(turn), 0));
    const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(frame, radius);
    caps.push_back(grid(sphere, {0.0, kRound}, {1.0, 1.5}, {}, Joint::Loose));
    rims.push_back(fromOcct(sphere->Value(0.5 * kRound, 1.0)));
  }
  const TopoDS_Shape shape = compound(caps);
  const auto edges = edgesNear(ShapeIndex(shape), rims);
  const ShapeFill blend = blended(shape, {.from = {edges[0]}, .to = {edges[1], edges[2]}});
  EXPECT_TRUE(blend.fill.report.withinTolerance) << text::verdict(blend.fill.report);
  for (const Vector3d& p : pointsOf(blend, 3))
    EXPECT_NEAR(p.norm(), radius, 1e-3 * blend.fill.report.diagonal);
}

TEST(BlendJunction, DoesNotDependOnOrderNorOnOrientation) {
  const std::vector<Pipe> pipes = skewPipes();
  const ShapeFill one = joined(pipes);
  const double limit = 1e-6 * one.fill.report.diagonal;
  EXPECT_LT(apart(one, joined({pipes[2], pipes[0], pipes[1]})), limit);
  EXPECT_LT(apart(one, joined({pipes[1], pipes[0], pipes[2]})), limit);
  const TopoDS_Shape turned = everySecondReversed(shapeOf(pipes));
  EXPECT_LT(apart(one, blended(turned, rimsOf(turned, pipes))), limit);
}

TEST(BlendJunction, DoesNotDependOnWhereRimsStart) {
  std::vector<Pipe> moved = skewPipes();
  for (Pipe& pipe : moved) pipe.start += 0.8;
  const ShapeFill one = joined(skewPipes());
  EXPECT_LT(apart(one, joined(moved)), 1e-6 * one.fill.report.diagonal);
}

// Three equal pipes a third of a turn apart: a turn by a third and the mirror at their plane bring
// the junction onto itself.
TEST(BlendJunction, HasTheSymmetryOfItsPipes) {
  std::vector<Pipe> pipes;
  for (int k = 0; k < 3; ++k)
    pipes.push_back({gp_Dir(std::cos(kRound * k / 3.0), std::sin(kRound * k / 3.0), 0)});
  const ShapeFill blend = joined(pipes);
  EXPECT_TRUE(blend.fill.report.withinTolerance) << text::verdict(blend.fill.report);
  const double limit = 1e-6 * blend.fill.report.diagonal;
  gp_Trsf mirror, turn;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), kRound / 3.0);
  for (const gp_Trsf& motion : {mirror, turn}) {
    ShapeFill moved = blend;
    moved.shape = BRepBuilderAPI_Transform(blend.shape, motion, true).Shape();
    EXPECT_LT(apart(blend, moved), limit);
  }
}

TEST(BlendJunction, JoinsFourPipes) {
  std::vector<Pipe> pipes;
  for (const gp_Dir& axis :
       {gp_Dir(1, 0, 0.1), gp_Dir(-1, 0.1, 0), gp_Dir(0.1, 1, 0), gp_Dir(0, -1, -0.1)})
    pipes.push_back({axis, 4.0});
  const ShapeFill blend = joined(pipes);
  EXPECT_EQ(blend.fill.patches.size(), 16U);
  EXPECT_TRUE(blend.fill.report.withinTolerance) << text::verdict(blend.fill.report);
}

TEST(BlendJunction, ClosesCappedPipesToASolid) {
  std::vector<TopoDS_Shape> faces;
  for (const Pipe& pipe : skewPipes()) {
    faces.push_back(pipe.face());
    const gp_Pnt end = gp_Pnt(gp_Vec(pipe.axis).Multiplied(pipe.gap + 8.0).XYZ());
    const Handle(Geom_Surface) cap = new Geom_SphericalSurface(gp_Ax3(end, pipe.axis), pipe.radius);
    faces.push_back(
        grid(cap, {pipe.start, pipe.start + kRound}, {0.0, 0.25 * kRound}, {}, Joint::Loose));
  }
  const TopoDS_Shape shape = compound(faces);
  const ShapeFill blend = blended(shape, rimsOf(shape, skewPipes()), ResultMode::Base);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
  EXPECT_TRUE(TopExp_Explorer(blend.shape, TopAbs_SOLID).More());
  EXPECT_GT(volume(blend.shape), 1000.0);
}

// Mean length of the cross tangents along the rim of a pipe, over that at reach 1.
double legOf(const ShapeFill& blend, const Pipe& pipe) {
  double sum = 0.0;
  int count = 0;
  for (const spline::BsplineSurface& patch : blend.fill.patches)
    for (int k = 1; k < 8; ++k)
      for (const bool atEnd : {false, true}) {
        const double u = patch.u.first() + k / 8.0 * (patch.u.last() - patch.u.first());
        const double v = patch.v.first() + k / 8.0 * (patch.v.last() - patch.v.first());
        const auto south = patch.jet(u, atEnd ? patch.v.last() : patch.v.first());
        const auto west = patch.jet(atEnd ? patch.u.last() : patch.u.first(), v);
        for (const auto& [point, across] :
             {std::pair{south.point, south.v}, {west.point, west.u}}) {
          const Vector3d axis = fromOcct(gp_Pnt(pipe.axis.XYZ()));
          if (std::abs(point.dot(axis) - pipe.gap) > 1e-4) continue;
          if (std::abs(point.cross(axis).norm() - pipe.radius) > 1e-4) continue;
          sum += across.norm();
          ++count;
        }
      }
  return sum / count;
}

TEST(BlendJunction, ReachesAsFarAsAskedAndStaysTangent) {
  const std::vector<Pipe> pipes = skewPipes();
  const TopoDS_Shape shape = shapeOf(pipes);
  const auto natural = tryBlend(shape, rimsOf(shape, pipes));
  ASSERT_TRUE(natural.has_value());
  const auto reached = reaching(*natural, {{1.3, 0.8}});
  ASSERT_TRUE(reached.has_value()) << text::sentence(reached.error());
  EXPECT_TRUE(reached->fill.report.withinTolerance);
  EXPECT_LT(reached->fill.report.largestAngle, 0.02);
  EXPECT_LT(reached->fill.report.largestSeamAngle, 0.02);
  EXPECT_NEAR(legOf(*reached, pipes[0]) / legOf(*natural, pipes[0]), 1.3, 0.03);
  EXPECT_NEAR(legOf(*reached, pipes[1]) / legOf(*natural, pipes[1]), 0.8, 0.03);
}

TEST(BlendJunction, RefusesOpenChainsAndAReachThatVaries) {
  const std::vector<Pipe> pipes = skewPipes();
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Ax3(gp_Pnt(0, 0, 30), gp_Dir(0, 0, 1)));
  const TopoDS_Shape shape =
      compound({shapeOf(pipes), grid(plane, {0.0, 5.0}, {0.0, 5.0}, {}, Joint::Loose)});
  const auto edges =
      edgesNear(ShapeIndex(shape), {pipes[0].rim(), pipes[1].rim(), Vector3d(2.5, 0, 30)});
  BlendPicks mixed{.from = {edges[0]}, .to = {edges[1], edges[2]}};
  EXPECT_EQ(refusal(shape, mixed), ErrorCode::ChainBroken);
  mixed.ring = true;
  EXPECT_EQ(refusal(shape, mixed), ErrorCode::ChainsUnlike);
  const BlendPicks rims = rimsOf(shape, pipes);
  EXPECT_EQ(refusal(shape, rims, {.reach = {{1.5, 1.0}, {1.2, std::nullopt}}}),
            ErrorCode::ReachVariesRound);
}

/// The rims of three skew pipes and, last in the shape, edges from rim to rim: from an angle on one
/// pipe to an angle on the next one.
struct CutPipes {
  TopoDS_Shape shape;
  BlendPicks picks;
  std::vector<Vector3d> ends;
};

CutPipes cutPipes(const std::vector<std::array<double, 2>>& angles) {
  const std::vector<Pipe> pipes = skewPipes();
  std::vector<TopoDS_Shape> parts{shapeOf(pipes)};
  CutPipes result;
  std::vector<Vector3d> middles;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const Pipe &one = pipes[k % 3], &next = pipes[(k + 1) % 3];
    const gp_Pnt a = one.surface()->Value(angles[k][0], one.gap);
    const gp_Pnt b = next.surface()->Value(angles[k][1], next.gap);
    parts.push_back(BRepBuilderAPI_MakeEdge(a, b).Shape());
    result.ends.insert(result.ends.end(), {fromOcct(a), fromOcct(b)});
    middles.push_back(0.5 * (fromOcct(a) + fromOcct(b)));
  }
  result.shape = compound(parts);
  result.picks = rimsOf(result.shape, pipes);
  result.picks.cuts = edgesNear(ShapeIndex(result.shape), middles);
  return result;
}

TEST(BlendJunction, IsCutWhereItIsShown) {
  const CutPipes pipes = cutPipes({{2.0, 6.0}, {3.4, 5.2}});
  const ShapeFill blend = blended(pipes.shape, pipes.picks);
  EXPECT_TRUE(blend.fill.report.withinTolerance) << text::verdict(blend.fill.report);
  for (const Vector3d& end : pipes.ends) {
    double least = std::numeric_limits<double>::infinity();
    for (const spline::BsplineSurface& patch : blend.fill.patches)
      for (const double u : {patch.u.first(), patch.u.last()})
        for (const double v : {patch.v.first(), patch.v.last()})
          least = std::min(least, (patch.jet(u, v).point - end).norm());
    EXPECT_LT(least, 1e-6) << end.transpose();
  }
}

TEST(BlendJunction, SaysWhichCutsDoNotSuit) {
  const auto codeOf = [](const CutPipes& pipes) { return refusal(pipes.shape, pipes.picks); };
  EXPECT_EQ(codeOf(cutPipes({{2.0, 6.0}, {3.4, 5.2}, {0.0, 2.0}, {2.2, 6.2}})),
            ErrorCode::CutUnfit);
  CutPipes pipes = cutPipes({{2.0, 6.0}});
  pipes.picks.cuts = edgesNear(ShapeIndex(pipes.shape), {skewPipes().front().rim()});
  EXPECT_EQ(codeOf(pipes), ErrorCode::CutUnfit);
  pipes = cutPipes({{2.0, 6.0}, {6.1, 5.2}});
  EXPECT_EQ(codeOf(pipes), ErrorCode::CutsTooClose);
  pipes = cutPipes({{2.0, 6.0}});
  pipes.shape = compound(
      {shapeOf(skewPipes()), BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 3)).Shape()});
  pipes.picks = rimsOf(pipes.shape, skewPipes());
  pipes.picks.cuts = edgesNear(ShapeIndex(pipes.shape), {Vector3d(0, 0, 1.5)});
  EXPECT_EQ(codeOf(pipes), ErrorCode::CutOffRims);
}

// Pipes that end so near the origin that each one's wall cuts through the next one's.
TEST(BlendJunction, TellsWherePipesOverlap) {
  std::vector<Pipe> pipes = skewPipes();
  const auto codesOf = [](const ShapeFill& blend) {
    std::vector<analysis::NoteCode> codes;
    for (const analysis::Note& note : blend.fill.report.notes) codes.push_back(note.code);
    return codes;
  };
  EXPECT_THAT(codesOf(joined(pipes)), ::testing::IsEmpty());
  pipes[0].gap = pipes[1].gap = 1.0;
  EXPECT_THAT(codesOf(joined(pipes)), ::testing::Contains(analysis::NoteCode::BasesOverlap));
}

TEST(BlendJunction, TakesNothingThatSaysWhichPointsBelongTogether) {
  const std::vector<Pipe> pipes = skewPipes();
  const TopoDS_Shape shape = shapeOf(pipes);
  for (const auto wish : {+[](BlendPicks& picks) { picks.match = boundary::MatchKind::Length; },
                          +[](BlendPicks& picks) { picks.alignment = 0.1; },
                          +[](BlendPicks& picks) { picks.pairs = {{1, 2}}; },
                          +[](BlendPicks& picks) { picks.setback = {1.0, 0.0}; },
                          +[](BlendPicks& picks) { picks.setbackCurve[1] = {1}; }}) {
    BlendPicks picks = rimsOf(shape, pipes);
    wish(picks);
    EXPECT_EQ(refusal(shape, picks), ErrorCode::JunctionWish);
  }
}

}  // namespace
}  // namespace fairing::occt
