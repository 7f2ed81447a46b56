// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/find_loop.h"

#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <random>

#include "occt/find_holes.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;
using ::testing::ElementsAreArray;
using ::testing::UnorderedElementsAreArray;

ErrorCode codeOf(const Result<std::vector<int>>& result) {
  EXPECT_FALSE(result.has_value());
  return result ? ErrorCode::Foreign : result.error().code;
}

Handle(Geom_Plane) plane() {
  return new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
}

TopoDS_Edge line(const Vector3d& a, const Vector3d& b) {
  return BRepBuilderAPI_MakeEdge(gp_Pnt(a.x(), a.y(), a.z()), gp_Pnt(b.x(), b.y(), b.z())).Edge();
}

/// The four sides of the middle cell of a 3 x 3 grid of 10 mm cells, by their middles.
const std::vector<Vector3d> kMiddles{{15, 10, 0}, {20, 15, 0}, {15, 20, 0}, {10, 15, 0}};

TopoDS_Shape planeWithHole(Joint joint = Joint::Sewn) {
  return grid(plane(), {0, 10, 20, 30}, {0, 10, 20, 30}, {{1, 1}}, joint);
}

TEST(FindLoop, IsTheSameFromAnyEdgeInAnyOrder) {
  const ShapeIndex index(planeWithHole());
  std::vector<int> sides = edgesNear(index, kMiddles);
  const auto reference = findLoop(index, {.edges = {sides[0]}});
  ASSERT_TRUE(reference.has_value());
  EXPECT_THAT(*reference, UnorderedElementsAreArray(sides));
  EXPECT_EQ(reference->front(), *std::min_element(sides.begin(), sides.end()));
  std::mt19937 random{0};
  for (int trial = 0; trial < 50; ++trial) {
    std::shuffle(sides.begin(), sides.end(), random);
    const auto count = 1 + std::size_t(trial) % sides.size();
    const auto loop = findLoop(index, {.edges = {sides.begin(), sides.begin() + long(count)}});
    ASSERT_TRUE(loop.has_value());
    EXPECT_THAT(*loop, ElementsAreArray(*reference));
  }
}

/// Signed area of the polygon through the starts of the loop's edges, from above.
double signedArea(const ShapeIndex& index, const Picks& picks) {
  const BorderGraph graph = BorderGraph::build(index, picks);
  const auto loop = traceLoop(index, graph, picks);
  if (!loop) return 0.0;
  double twice = 0.0;
  for (std::size_t i = 0; i < loop->size(); ++i) {
    const auto start = [&](std::size_t k) {
      const LoopEdge& e = (*loop)[k % loop->size()];
      return graph.point(graph.edges()[std::size_t(e.border)].from(e.direction));
    };
    twice += start(i).cross(start(i + 1)).z();
  }
  return 0.5 * twice;
}

TEST(FindLoop, LeavesTheHoleToTheLeftSeenAgainstTheNormals) {
  const TopoDS_Shape shape = planeWithHole();
  const ShapeIndex index(shape);
  EXPECT_NEAR(signedArea(index, {.edges = edgesNear(index, kMiddles)}), 100.0, 1e-9);
  const ShapeIndex turned(shape.Reversed());
  EXPECT_NEAR(signedArea(turned, {.edges = edgesNear(turned, kMiddles)}), -100.0, 1e-9);
}

TEST(FindLoop, FindsHolesOfLooseFaces) {
  const ShapeIndex index(planeWithHole(Joint::Loose));
  const std::vector<int> sides = edgesNear(index, kMiddles);
  for (int side : sides) {
    const auto loop = findLoop(index, {.edges = {side}});
    ASSERT_TRUE(loop.has_value()) << int(loop.error().code);
    EXPECT_THAT(*loop, UnorderedElementsAreArray(sides));
  }
  // Two loose faces that share a border have no hole there.
  const std::vector<int> between = edgesNear(index, {{5, 10, 0}});
  EXPECT_EQ(codeOf(findLoop(index, {.edges = between})), ErrorCode::EdgeNotFree);
}

TEST(FindLoop, IgnoresHowFacesAreOriented) {
  const ShapeIndex index(everySecondReversed(planeWithHole()));
  const std::vector<int> sides = edgesNear(index, kMiddles);
  const auto loop = findLoop(index, {.edges = {sides[2]}});
  ASSERT_TRUE(loop.has_value());
  EXPECT_THAT(*loop, UnorderedElementsAreArray(sides));
}

TEST(FindLoop, TakesTheBorderOfAPickedFace) {
  const ShapeIndex index(box(10, 20, 30));
  for (int face = 1; face <= 6; ++face) {
    const auto loop = findLoop(index, {.edges = {}, .faces = {face}});
    ASSERT_TRUE(loop.has_value());
    EXPECT_EQ(loop->size(), 4u);
    const auto fromOneEdge = findLoop(index, {.edges = {loop->back()}, .faces = {face}});
    ASSERT_TRUE(fromOneEdge.has_value());
    EXPECT_EQ(*fromOneEdge, *loop);
  }
  // Two faces side by side: six edges around both, none between them.
  const auto both = findLoop(index, {.edges = {}, .faces = {1, 3}});
  ASSERT_TRUE(both.has_value());
  EXPECT_EQ(both->size(), 6u);
}

TEST(FindLoop, GoesOnAroundTheSameGapWhereHolesTouch) {
  // Two holes that share a corner: four free edges meet there.
  const ShapeIndex index(grid(plane(), {0, 10, 20, 30, 40}, {0, 10, 20, 30, 40}, {{1, 1}, {2, 2}}));
  const std::vector<int> first = edgesNear(index, kMiddles);
  const std::vector<int> second =
      edgesNear(index, {{25, 20, 0}, {30, 25, 0}, {25, 30, 0}, {20, 25, 0}});
  for (const auto& sides : {first, second}) {
    for (int side : sides) {
      const auto loop = findLoop(index, {.edges = {side}});
      ASSERT_TRUE(loop.has_value());
      EXPECT_THAT(*loop, UnorderedElementsAreArray(sides));
    }
  }
}

TEST(FindLoop, ClosesOverALoneEdge) {
  // The upper neighbour of the hole is missing; a lone edge stands in for its border.
  TopoDS_Shape sheet = grid(plane(), {0, 10, 20, 30}, {0, 10, 20, 30}, {{1, 1}, {1, 2}});
  const TopoDS_Shape shape = compound({sheet, line({10, 20, 0}, {20, 20, 0})});
  const ShapeIndex index(shape);
  const std::vector<int> sides = edgesNear(index, kMiddles);
  ASSERT_TRUE(index.uses(sides[2]).empty());
  for (int side : sides) {
    const auto loop = findLoop(index, {.edges = {side}});
    ASSERT_TRUE(loop.has_value());
    EXPECT_THAT(*loop, UnorderedElementsAreArray(sides));
  }
}

TEST(FindLoop, OverlooksLoneEdgesThatLeadNowhere) {
  const TopoDS_Shape shape =
      compound({planeWithHole(), line({10, 10, 0}, {13, 14, 0}), line({13, 14, 0}, {15, 15, 0})});
  const ShapeIndex index(shape);
  const std::vector<int> sides = edgesNear(index, kMiddles);
  const auto loop = findLoop(index, {.edges = {sides[0]}});
  ASSERT_TRUE(loop.has_value());
  EXPECT_THAT(*loop, UnorderedElementsAreArray(sides));
}

TEST(FindLoop, TellsTheGapOfALoopThatDoesNotClose) {
  const TopoDS_Shape shape = compound({line({0, 0, 0}, {10, 0, 0}),
                                       line({10, 0, 0}, {10, 10, 0}),
                                       line({10, 10, 0}, {0, 10, 0}),
                                       line({0, 10, 0}, {0, 0.25, 0})});
  const ShapeIndex index(shape);
  const auto loop = findLoop(index, {.edges = {1, 2, 3, 4}});
  ASSERT_EQ(codeOf(loop), ErrorCode::LoopNotClosed);
  EXPECT_NEAR(loop.error().value, 0.25, 1e-12);
  ASSERT_TRUE(loop.error().where.has_value());
  EXPECT_LT(loop.error().where->norm(), 0.26);
  EXPECT_TRUE(loop.error().edge == 1 || loop.error().edge == 4);
}

TEST(FindLoop, RefusesWhatBordersNoHole) {
  const ShapeIndex index(box(10, 10, 10));
  EXPECT_EQ(codeOf(findLoop(index, {.edges = {3}})), ErrorCode::EdgeNotFree);
  EXPECT_EQ(codeOf(findLoop(index, {.edges = {13}})), ErrorCode::EdgeOutOfRange);
  EXPECT_EQ(codeOf(findLoop(index, {.edges = {0}})), ErrorCode::EdgeOutOfRange);
  EXPECT_EQ(codeOf(findLoop(index, {.edges = {-4}})), ErrorCode::EdgeOutOfRange);
  EXPECT_EQ(codeOf(findLoop(index, {.edges = {}, .faces = {7}})), ErrorCode::FaceOutOfRange);
  EXPECT_EQ(codeOf(findLoop(index, {})), ErrorCode::NothingPicked);
  EXPECT_EQ(codeOf(findLoop(index, {.edges = {3, 3}})), ErrorCode::EdgePickedTwice);
}

TEST(FindLoop, RefusesEdgesOfTwoHoles) {
  const ShapeIndex index(grid(plane(), {0, 10, 20, 30, 40, 50}, {0, 10, 20, 30}, {{1, 1}, {3, 1}}));
  const std::vector<int> picks = edgesNear(index, {{15, 10, 0}, {35, 10, 0}});
  const auto loop = findLoop(index, {.edges = picks});
  ASSERT_EQ(codeOf(loop), ErrorCode::SeveralLoops);
  EXPECT_EQ(loop.error().value, 2.0);
  EXPECT_EQ(loop.error().edge, std::max(picks[0], picks[1]));
}

TEST(FindLoop, RefusesAFaceWithAHoleOfItsOwn) {
  const TopoDS_Shape drilled = drilledBox(10, 10, 2);
  const ShapeIndex index(drilled);
  int top = 0;
  for (int face = 1; face <= index.faceCount(); ++face) {
    if (area(index.face(face)) < 99.0 && area(index.face(face)) > 80.0) top = face;
  }
  ASSERT_GT(top, 0);
  EXPECT_EQ(codeOf(findLoop(index, {.edges = {}, .faces = {top}})), ErrorCode::SeveralLoops);
}

TEST(FindLoop, RefusesAnEdgeOfThreeFaces) {
  const TopoDS_Shape three = compound(
      {BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0, 10, 0, 10).Shape(),
       BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), -10, 0, 0, 10).Shape(),
       BRepBuilderAPI_MakeFace(
           gp_Pln(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0), gp_Dir(0, 1, 0))), 0, 10, 0, 10)
           .Shape()});
  const ShapeIndex index(three);
  const auto loop = findLoop(index, {.edges = edgesNear(index, {{0, 5, 0}})});
  ASSERT_EQ(codeOf(loop), ErrorCode::EdgeWithManyFaces);
  EXPECT_EQ(loop.error().value, 3.0);
}

TEST(FindLoop, RefusesADegenerateEdge) {
  const ShapeIndex index(BRepPrimAPI_MakeSphere(5.0).Shape());
  int pole = 0;
  for (int edge = 1; edge <= index.edgeCount(); ++edge) {
    if (BRep_Tool::Degenerated(index.edge(edge))) pole = edge;
  }
  ASSERT_GT(pole, 0);
  const auto loop = findLoop(index, {.edges = {pole}});
  ASSERT_EQ(codeOf(loop), ErrorCode::EdgeDegenerate);
  EXPECT_NEAR(loop.error().where->norm(), 5.0, 1e-9);
}

TEST(FindLoop, RefusesALoopThatTouchesItself) {
  // A bow tie of lone edges, crossing in a vertex.
  const TopoDS_Shape shape = compound({line({0, 0, 0}, {5, 5, 0}),
                                       line({5, 5, 0}, {10, 10, 0}),
                                       line({10, 10, 0}, {10, 0, 0}),
                                       line({10, 0, 0}, {5, 5, 0}),
                                       line({5, 5, 0}, {0, 10, 0}),
                                       line({0, 10, 0}, {0, 0, 0})});
  const ShapeIndex index(shape);
  const ErrorCode code = codeOf(findLoop(index, {.edges = {1, 2, 3, 4, 5, 6}}));
  EXPECT_TRUE(code == ErrorCode::LoopSelfTouching || code == ErrorCode::LoopBranches) << int(code);
}

class FindHolesOf : public ::testing::TestWithParam<Joint> {};

TEST_P(FindHolesOf, TellsHolesFromTheOuterBorder) {
  const ShapeIndex index(
      grid(plane(), {0, 10, 20, 30, 40, 50}, {0, 10, 20, 30}, {{1, 1}, {3, 1}}, GetParam()));
  const std::vector<Hole> holes = findHoles(index);
  ASSERT_EQ(holes.size(), 3u);
  EXPECT_EQ(std::count_if(
                holes.begin(), holes.end(), [](const Hole& hole) { return hole.isOuterBorder; }),
            1);
  for (const Hole& hole : holes) EXPECT_EQ(hole.edges.size(), hole.isOuterBorder ? 16u : 4u);
}

INSTANTIATE_TEST_SUITE_P(Sheets, FindHolesOf, ::testing::Values(Joint::Sewn, Joint::Loose));

TEST(FindHoles, TakesBothEndsOfAPipeAsHoles) {
  auto pipe = BRepPrimAPI_MakeCylinder(5.0, 20.0);
  const ShapeIndex solid(pipe.Solid());
  const ShapeIndex index(solid.face(1));
  const std::vector<Hole> holes = findHoles(index);
  ASSERT_EQ(holes.size(), 2u);
  for (const Hole& hole : holes) {
    EXPECT_FALSE(hole.isOuterBorder);
    EXPECT_EQ(hole.edges.size(), 1u);
  }
}

TEST(FindHoles, FindsNoneInASolid) {
  EXPECT_TRUE(findHoles(ShapeIndex(box(1, 2, 3))).empty());
}

}  // namespace
}  // namespace fairing::occt
