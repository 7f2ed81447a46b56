// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/direction_support.h"

#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <Eigen/Geometry>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <cmath>
#include <numbers>

#include "occt/fill_shape.h"
#include "occt/read_boundary.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;
using Kind = EdgeDirection::Kind;

/// Four edges without faces: two arcs that bulge up by 5 mm over 40 mm in the planes y = 0 and
/// y = 20, and the lines x = 0 and x = 40 between their ends.
TopoDS_Shape archFrame() {
  const auto arc = [](double y) {
    return BRepBuilderAPI_MakeEdge(
               GC_MakeArcOfCircle(gp_Pnt(0, y, 0), gp_Pnt(20, y, 5), gp_Pnt(40, y, 0)).Value())
        .Shape();
  };
  const auto line = [](double x) {
    return BRepBuilderAPI_MakeEdge(gp_Pnt(x, 0, 0), gp_Pnt(x, 20, 0)).Shape();
  };
  return compound({arc(0), arc(20), line(0), line(40)});
}

struct Frame {
  ShapeIndex index{archFrame()};
  std::vector<int> edges = edgesNear(index, {{20, 0, 5}, {20, 20, 5}, {0, 10, 0}, {40, 10, 0}});
  Picks picks{.edges = {1, 2, 3, 4}};
};

const boundary::BoundarySide& sideOf(const boundary::BoundaryLoop& loop, int edge) {
  for (const auto& side : loop.sides)
    if (side.edge == edge) return side;
  return loop.sides.front();
}

TEST(Directions, MakeTheTangentPlaneHoldTheDirection) {
  Frame frame;
  const Vector3d up(0.0, 1.0, 2.0);
  frame.picks.directions[frame.edges[0]] = {up, Kind::Tangent};
  const auto loop = readBoundary(frame.index, frame.picks);
  ASSERT_TRUE(loop.has_value());
  const auto& side = sideOf(*loop, frame.edges[0]);
  EXPECT_EQ(side.continuity, Continuity::G1);
  EXPECT_EQ(side.face, 0);
  for (double t : {0.0, 0.2, 0.9, 1.0}) {
    const Vector3d normal = side.ribbon.support(t).normal;
    EXPECT_NEAR(normal.norm(), 1.0, 1e-14);
    EXPECT_NEAR(normal.dot(up.normalized()), 0.0, 1e-14);
    EXPECT_NEAR(normal.dot(side.ribbon.curve(t).derivative.normalized()), 0.0, 1e-14);
  }
}

TEST(Directions, PointIntoTheHoleWhicheverWayTheyAreGiven) {
  for (double sign : {1.0, -1.0}) {
    Frame frame;
    frame.picks.directions[frame.edges[0]] = {sign * Vector3d(0, 1, 0.2), Kind::Tangent};
    const auto loop = readBoundary(frame.index, frame.picks);
    ASSERT_TRUE(loop.has_value());
    const auto& ribbon = sideOf(*loop, frame.edges[0]).ribbon;
    // The hole lies to the left of the side seen against the normal.
    const Vector3d left = ribbon.support(0.5).normal.cross(ribbon.curve(0.5).derivative);
    EXPECT_GT(left.y(), 0.0);
  }
}

TEST(Directions, LetThePatchMeetItsMirrorImageTangentially) {
  Frame frame;
  frame.picks.directions[frame.edges[0]] = {{0, 1, 0}, Kind::Symmetry};
  frame.picks.directions[frame.edges[1]] = {{0, -3, 0}, Kind::Symmetry};
  const auto filled = fillShape(frame.index, frame.picks, {}, ResultMode::Patches);
  ASSERT_TRUE(filled.has_value());
  EXPECT_TRUE(filled->fill.report.withinTolerance);
  for (const auto& side : filled->fill.report.sides) {
    if (side.edge != frame.edges[0] && side.edge != frame.edges[1]) continue;
    EXPECT_EQ(side.asked, Continuity::G1);
    EXPECT_GT(side.angle.count, 0);
    EXPECT_LT(side.angle.max, 0.02);
    EXPECT_FALSE(side.backwards);
  }
}

TEST(Directions, GoBeforeTheFaceBesideAnEdge) {
  const TopoDS_Shape shape = sheetWithHole();
  const ShapeIndex index(shape);
  const int edge = innerFreeEdges(index)[0];
  const auto plain = readBoundary(index, {.edges = {edge}});
  ASSERT_TRUE(plain.has_value());
  const auto& ribbon = sideOf(*plain, edge).ribbon;
  const Vector3d across = ribbon.support(0.5).normal.cross(ribbon.curve(0.5).derivative);
  const Vector3d tilted = across.normalized() + Vector3d(0, 0, 0.5);
  const auto loop = readBoundary(index, {.edges = {edge}, .directions = {{edge, {tilted}}}});
  ASSERT_TRUE(loop.has_value());
  EXPECT_NEAR(sideOf(*loop, edge).ribbon.support(0.5).normal.dot(tilted.normalized()), 0.0, 1e-12);
  EXPECT_GT(sideOf(*loop, edge).face, 0);
}

TEST(Directions, AreRefusedWhereTheyRunAlongTheEdge) {
  Frame frame;
  frame.picks.directions[frame.edges[2]] = {{0, 1, 0.001}, Kind::Tangent};
  const auto loop = readBoundary(frame.index, frame.picks);
  ASSERT_FALSE(loop.has_value());
  EXPECT_EQ(loop.error().code, ErrorCode::DirectionAlongEdge);
  EXPECT_EQ(loop.error().edge, frame.edges[2]);
  EXPECT_TRUE(loop.error().where.has_value());
}

TEST(Directions, AreRefusedWhereTheEdgeIsNotInTheSymmetryPlane) {
  Frame frame;
  frame.picks.directions[frame.edges[0]] = {{0, 1, 1}, Kind::Symmetry};
  const auto loop = readBoundary(frame.index, frame.picks);
  ASSERT_FALSE(loop.has_value());
  EXPECT_EQ(loop.error().code, ErrorCode::EdgeOffPlane);
  EXPECT_NEAR(loop.error().value, 5.0 / std::numbers::sqrt2, 0.1);
}

TEST(Directions, AreRefusedForEdgesOfNoSide) {
  const TopoDS_Shape shape = sheetWithHole();
  const ShapeIndex index(shape);
  int inside = 1;
  while (index.uses(inside).size() < 2) ++inside;
  const auto loop =
      readBoundary(index, {.edges = {innerFreeEdges(index)[0]}, .directions = {{inside, {}}}});
  ASSERT_FALSE(loop.has_value());
  EXPECT_EQ(loop.error().code, ErrorCode::EdgeNotInLoop);
}

}  // namespace
}  // namespace fairing::occt
