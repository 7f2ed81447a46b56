// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <cmath>
#include <numbers>

#include "occt/fill_shape.h"
#include "occt/inner_constraints.h"
#include "occt/loop_crossing.h"
#include "occt/read_boundary.h"
#include "occt/shapes.h"

// What users hand in that cannot work, or works with a word: one code or note each.
namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;

TopoDS_Shape edgesRound(const std::vector<Vector3d>& points) {
  std::vector<TopoDS_Shape> edges;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d& a = points[i];
    const Vector3d& b = points[(i + 1) % points.size()];
    edges.push_back(
        BRepBuilderAPI_MakeEdge(gp_Pnt(a.x(), a.y(), a.z()), gp_Pnt(b.x(), b.y(), b.z())).Shape());
  }
  return compound(edges);
}

Error errorOf(const TopoDS_Shape& shape, const Picks& picks, const FillOptions& options = {}) {
  const auto result = fillShape(ShapeIndex(shape), picks, options, ResultMode::Patches);
  return result ? Error{} : result.error();
}

TEST(BadInput, ALoopThatCrossesItselfIsNamedWithThePlace) {
  const TopoDS_Shape bow = edgesRound({{0, 0, 0}, {10, 10, 0}, {10, 0, 0}, {0, 10, 0}});
  const Error error = errorOf(bow, {.edges = {1, 2, 3, 4}});
  EXPECT_EQ(error.code, ErrorCode::LoopCrossesItself);
  ASSERT_TRUE(error.where.has_value());
  EXPECT_LT((*error.where - Vector3d(5, 5, 0)).norm(), 1e-4);
}

TEST(BadInput, ALoopThatPassesItselfAtADistanceIsNotRefused) {
  const TopoDS_Shape twisted = edgesRound({{0, 0, 0}, {10, 10, 0}, {10, 0, 2}, {0, 10, 2}});
  EXPECT_TRUE(readBoundary(ShapeIndex(twisted), {.edges = {1, 2, 3, 4}}).has_value());
  const TopoDS_Shape sharp = edgesRound({{0, 0, 0}, {30, 0, 0}, {30, 0.2, 0}, {0, 0.1, 0}});
  EXPECT_TRUE(readBoundary(ShapeIndex(sharp), {.edges = {1, 2, 3, 4}}).has_value());
  EXPECT_TRUE(readBoundary(ShapeIndex(sheetWithHole()),
                           {.edges = innerFreeEdges(ShapeIndex(sheetWithHole()))})
                  .has_value());
}

TEST(BadInput, TwoLoopsWhereOneIsExpected) {
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const TopoDS_Shape shape =
      grid(plane, {0, 10, 20, 30, 40, 50}, {0, 10, 20, 30}, {{1, 1}, {3, 1}});
  const auto edges = edgesNear(ShapeIndex(shape), {{15, 10, 0}, {35, 10, 0}});
  const Error error = errorOf(shape, {.edges = edges});
  EXPECT_EQ(error.code, ErrorCode::SeveralLoops);
  EXPECT_EQ(error.value, 2.0);
}

TEST(BadInput, AShapeWithoutHoles) {
  EXPECT_EQ(errorOf(box(1, 2, 3), {}).code, ErrorCode::NothingPicked);
}

TEST(BadInput, AnInnerPointFartherOffThanTheLoopIsLarge) {
  const TopoDS_Shape shape = sheetWithHole();
  FillOptions options;
  options.through = {throughPoint({15, 15, 300})};
  const Error error = errorOf(shape, {.edges = innerFreeEdges(ShapeIndex(shape))}, options);
  EXPECT_EQ(error.code, ErrorCode::InnerConstraintOff);
  EXPECT_GT(error.value, 280.0);
}

TEST(BadInput, AFaceWithoutNormalAtItsPoleIsNamedAndGoneOnWith) {
  // The cell below the pole of a sphere: its upper neighbours are triangles that end in the pole.
  const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), 20.0);
  const TopoDS_Shape shape =
      grid(sphere, {0.0, kPi / 6, kPi / 3, kPi / 2}, {0.2, 0.7, kPi / 2}, {{1, 1}}, Joint::Sewn);
  const ShapeIndex index(shape);
  const auto edges = edgesNear(index,
                               {Vector3d(20 * std::cos(0.7) * std::cos(kPi / 4),
                                         20 * std::cos(0.7) * std::sin(kPi / 4),
                                         20 * std::sin(0.7))});
  const auto loop = readBoundary(index, {.edges = edges});
  ASSERT_TRUE(loop.has_value()) << int(loop.error().code);
  int limits = 0;
  for (const auto& side : loop->sides) {
    for (double t : {0.0, 1.0}) {
      const auto support = side.ribbon.support(t);
      EXPECT_FALSE(support.singular);
      if (!support.isLimit) continue;
      ++limits;
      EXPECT_NEAR(std::abs(support.normal.z()), 1.0, 1e-4) << "the pole's normal";
    }
  }
  EXPECT_EQ(limits, 2);
}

TEST(InnerConstraints, ComeFromEdgesVerticesAndShapes) {
  const TopoDS_Shape shape =
      compound({box(10, 20, 30), BRepBuilderAPI_MakeVertex(gp_Pnt(1, 2, 3)).Shape()});
  const ShapeIndex index(shape);
  const int edge = edgesNear(index, {{5, 0, 0}})[0];
  const auto parts = throughParts(index, {edge}, {9});
  ASSERT_TRUE(parts.has_value());
  ASSERT_EQ(parts->size(), 2u);
  EXPECT_FALSE((*parts)[0].isPoint);
  EXPECT_LT(((*parts)[0].at(0.5) - Vector3d(5, 0, 0)).norm(), 1e-12);
  EXPECT_TRUE((*parts)[1].isPoint);
  EXPECT_LT(((*parts)[1].at(0.3) - Vector3d(1, 2, 3)).norm(), 1e-12);
  EXPECT_EQ(throughShape(shape)->size(), 13u);
  EXPECT_EQ(throughParts(index, {99}, {}).error().code, ErrorCode::EdgeOutOfRange);
  EXPECT_EQ(throughParts(index, {}, {10}).error().code, ErrorCode::VertexOutOfRange);
  EXPECT_EQ(throughShape(compound({})).error().code, ErrorCode::ShapeEmpty);
}

}  // namespace
}  // namespace fairing::occt
