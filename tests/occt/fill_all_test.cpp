// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/fill_all.h"

#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <mutex>
#include <numbers>
#include <set>
#include <string>
#include <thread>

#include "core/base/parallel_for.h"
#include "occt/find_holes.h"
#include "occt/reference.h"
#include "occt/shape_bytes.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;

/// 7 x 7 faces of the waved sheet without nine of them, no two of which touch.
TopoDS_Shape sheetWithNineHoles() {
  const Handle(Geom_Surface) surface = wavedSheet();
  double u0, u1, v0, v1;
  surface->Bounds(u0, u1, v0, v1);
  const auto parts = [](double a, double b) {
    std::vector<double> result;
    for (int i = 0; i <= 7; ++i) result.push_back(a + (b - a) * i / 7.0);
    return result;
  };
  std::set<Cell> holes;
  for (int i : {1, 3, 5})
    for (int j : {1, 3, 5}) holes.insert({i, j});
  return grid(surface, parts(u0, u1), parts(v0, v1), holes);
}

/// The shape's faces but the one nearest to a point.
TopoDS_Shape withoutFace(const TopoDS_Shape& shape, const gp_Pnt& near) {
  const ShapeIndex index(shape);
  const TopoDS_Shape point = BRepBuilderAPI_MakeVertex(near).Shape();
  const auto distance = [&](int face) {
    return BRepExtrema_DistShapeShape(point, index.face(face)).Value();
  };
  int nearest = 1;
  for (int face = 2; face <= index.faceCount(); ++face)
    if (distance(face) < distance(nearest)) nearest = face;
  std::vector<TopoDS_Shape> kept;
  for (int face = 1; face <= index.faceCount(); ++face)
    if (face != nearest) kept.push_back(index.face(face));
  return compound(kept);
}

std::string bytesOf(const TopoDS_Shape& shape) {
  const auto bytes = bytesFromShape(shape);
  return bytes ? *bytes : std::string();
}

TEST(FillAll, ClosesEveryHoleButTheOuterBorder) {
  const ShapeIndex index(sheetWithNineHoles());
  const auto all = fillAll(index, {}, {}, ResultMode::Base);
  ASSERT_TRUE(all.has_value());
  EXPECT_EQ(all->holes.size(), 9u);
  EXPECT_TRUE(all->withinTolerance());
  EXPECT_TRUE(BRepCheck_Analyzer(all->shape).IsValid());
  EXPECT_EQ(ShapeIndex(all->shape).faceCount(), 49);
  const std::vector<Hole> left = findHoles(ShapeIndex(all->shape));
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].edges.size(), 28u);
}

TEST(FillAll, GivesTheSameBitForBitOnOneThreadAndOnMany) {
  const ShapeIndex index(sheetWithNineHoles());
  const auto chosen = chooseHoles(index, {});
  ASSERT_TRUE(chosen.has_value());
  const auto serial = fillHoles(index, *chosen, {}, nullptr, 1);
  for (int threads : {2, 8}) {
    const auto parallel = fillHoles(index, *chosen, {}, nullptr, threads);
    ASSERT_EQ(parallel.size(), serial.size());
    for (std::size_t i = 0; i < serial.size(); ++i) {
      EXPECT_EQ(parallel[i].edges, serial[i].edges);
      ASSERT_TRUE(serial[i].fill.has_value() && parallel[i].fill.has_value());
      const auto& one = serial[i].fill->fill.patches;
      const auto& other = parallel[i].fill->fill.patches;
      ASSERT_EQ(one.size(), other.size());
      for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].poles, other[k].poles);
      EXPECT_EQ(bytesOf(serial[i].fill->shape), bytesOf(parallel[i].fill->shape));
    }
  }
}

TEST(FillAll, GivesTheSameWithAReferenceThatAllThreadsAsk) {
  const ShapeIndex index(sheetWithNineHoles());
  const auto chosen = chooseHoles(index, {});
  ASSERT_TRUE(chosen.has_value());
  FillOptions options;
  auto reference = referenceOn(grid(wavedSheet(), {0, 0.5, 1}, {0, 0.5, 1}, {}));
  ASSERT_TRUE(reference.has_value());
  options.guidance.reference = *reference;
  options.guidance.lambda = options.guidance.gamma = 100.0;
  const auto serial = fillHoles(index, *chosen, options, nullptr, 1);
  const auto parallel = fillHoles(index, *chosen, options, nullptr, 4);
  for (std::size_t i = 0; i < serial.size(); ++i) {
    ASSERT_TRUE(serial[i].fill.has_value() && parallel[i].fill.has_value());
    EXPECT_EQ(serial[i].fill->fill.patches[0].poles, parallel[i].fill->fill.patches[0].poles);
  }
}

TEST(FillAll, StartsNoFurtherThreadsForWhatAHoleDoesInParallel) {
  const ShapeIndex index(sheetWithNineHoles());
  const auto chosen = chooseHoles(index, {});
  ASSERT_TRUE(chosen.has_value());
  auto reference = referenceOn(grid(wavedSheet(), {0, 0.5, 1}, {0, 0.5, 1}, {}));
  ASSERT_TRUE(reference.has_value());
  std::mutex mutex;
  std::set<std::thread::id> seen;
  FillOptions options;
  options.guidance.gamma = 1.0;
  options.guidance.reference = [&](const Eigen::Vector3d& near) {  // asked by loops in parallel
    {
      const std::lock_guard lock(mutex);
      seen.insert(std::this_thread::get_id());
    }
    return (*reference)(near);
  };
  const ThreadShare two(2);
  for (const HoleFill& hole : fillHoles(index, *chosen, options))
    EXPECT_TRUE(hole.fill.has_value());
  EXPECT_FALSE(seen.empty());
  EXPECT_LE(seen.size(), 2u);
  EXPECT_EQ(threadsHere(), 2);
}

TEST(FillAll, LeavesTheOthersAloneWhereOneHoleFails) {
  const ShapeIndex index(sheetWithNineHoles());
  auto chosen = chooseHoles(index, {});
  ASSERT_TRUE(chosen.has_value());
  (*chosen)[4].edgeContinuity[9999] = Continuity::G1;  // no edge of that hole
  auto holes = fillHoles(index, *chosen, {});
  const auto all = joinHoles(index, std::move(holes), ResultMode::Base);
  ASSERT_TRUE(all.has_value());
  EXPECT_FALSE(all->withinTolerance());
  for (std::size_t i = 0; i < all->holes.size(); ++i) {
    EXPECT_EQ(all->holes[i].fill.has_value(), i != 4) << i;
  }
  EXPECT_EQ(all->holes[4].fill.error().code, ErrorCode::EdgeNotInLoop);
  EXPECT_EQ(ShapeIndex(all->shape).faceCount(), 48);
  EXPECT_TRUE(BRepCheck_Analyzer(all->shape).IsValid());
}

TEST(FillAll, LeavesOutWhatIsToBeSkipped) {
  const ShapeIndex index(sheetWithNineHoles());
  const auto every = chooseHoles(index, {});
  ASSERT_TRUE(every.has_value());
  const int skipped = (*every)[2].edges[3];
  const auto chosen = chooseHoles(index, {.skipped = {skipped}});
  ASSERT_TRUE(chosen.has_value());
  EXPECT_EQ(chosen->size(), 8u);
  for (const Picks& hole : *chosen)
    EXPECT_THAT(hole.edges, ::testing::Not(::testing::Contains(skipped)));
}

TEST(FillAll, GivesAWishToTheHoleThatHasTheEdge) {
  const ShapeIndex index(sheetWithNineHoles());
  const auto every = chooseHoles(index, {});
  ASSERT_TRUE(every.has_value());
  const int edge = (*every)[5].edges[1];
  const auto chosen = chooseHoles(index, {.edgeContinuity = {{edge, Continuity::G0}}});
  ASSERT_TRUE(chosen.has_value());
  for (std::size_t i = 0; i < chosen->size(); ++i) {
    EXPECT_EQ((*chosen)[i].edgeContinuity.size(), i == 5 ? 1u : 0u);
  }
}

TEST(FillAll, SaysWhatKeepsItFromFindingHoles) {
  const auto codeOf = [](const TopoDS_Shape& shape, const HoleChoice& choice) {
    const auto chosen = chooseHoles(ShapeIndex(shape), choice);
    return chosen ? ErrorCode::Foreign : chosen.error().code;
  };
  const TopoDS_Shape shape = sheetWithHole();
  const ShapeIndex index(shape);
  EXPECT_EQ(codeOf(box(1, 2, 3), {}), ErrorCode::NothingPicked);
  EXPECT_EQ(codeOf(compound({}), {}), ErrorCode::ShapeEmpty);
  EXPECT_EQ(codeOf(grid(wavedSheet(), {0, 0.5, 1}, {0, 0.5, 1}, {}), {}), ErrorCode::NoHole);
  EXPECT_EQ(codeOf(shape, {.skipped = {innerFreeEdges(index)[0]}}), ErrorCode::NoHole);
  EXPECT_EQ(codeOf(shape, {.edgeContinuity = {{99, Continuity::G0}}}), ErrorCode::EdgeOutOfRange);
  int inside = 1;
  while (index.uses(inside).size() < 2) ++inside;
  EXPECT_EQ(codeOf(shape, {.edgeContinuity = {{inside, Continuity::G0}}}),
            ErrorCode::EdgeNotInLoop);
}

TEST(FillAll, TakesTheMouthOfACupForAHoleAndTheRimOfASheetForABorder) {
  const ShapeIndex cup(withoutFace(box(10, 20, 30), {5, 10, 30}));
  ASSERT_EQ(findHoles(cup).size(), 1u);
  EXPECT_FALSE(findHoles(cup)[0].isOuterBorder);
  const ShapeIndex half(BRepPrimAPI_MakeSphere(10.0, 0.0, std::numbers::pi / 2).Shape());
  const ShapeIndex dome(withoutFace(half.shape(), {0, 0, 0}));
  ASSERT_EQ(findHoles(dome).size(), 1u);
  EXPECT_FALSE(findHoles(dome)[0].isOuterBorder);
  const ShapeIndex rim(grid(wavedSheet(), {0, 0.5, 1}, {0, 0.5, 1}, {}));
  ASSERT_EQ(findHoles(rim).size(), 1u);
  EXPECT_TRUE(findHoles(rim)[0].isOuterBorder);
}

TEST(FillAll, StopsAllHolesWhenAborted) {
  const ShapeIndex index(sheetWithNineHoles());
  Progress progress;
  progress.requestAbort();
  const auto all = fillAll(index, {}, {}, ResultMode::Patches, &progress);
  ASSERT_FALSE(all.has_value());
  EXPECT_EQ(all.error().code, ErrorCode::Cancelled);
}

TEST(FillAll, CountsProgressOverAllHoles) {
  const ShapeIndex index(sheetWithNineHoles());
  Progress progress;
  ASSERT_TRUE(fillAll(index, {}, {}, ResultMode::Patches, &progress).has_value());
  EXPECT_DOUBLE_EQ(progress.fraction(), 1.0);
}

TEST(FillAll, KeepsTheFacesOfEveryHoleTogetherInAShellOfItsOwn) {
  const ShapeIndex index(sheetWithNineHoles());
  const auto all = fillAll(index, {}, {}, ResultMode::Shell);
  ASSERT_TRUE(all.has_value());
  ASSERT_EQ(all->shape.ShapeType(), TopAbs_COMPOUND);
  EXPECT_TRUE(BRepCheck_Analyzer(all->shape).IsValid());
}

}  // namespace
}  // namespace fairing::occt
