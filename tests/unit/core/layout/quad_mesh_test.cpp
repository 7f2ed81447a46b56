// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/quad_mesh.h"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <utility>

#include "core/layout/build_layout.h"
#include "core/layout/layouts.h"
#include "support/many_sided_loops.h"

namespace fairing::layout {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

LayoutPlan star(int corners) {
  return planLayout(finished(polygonOn(plane(), corners)), LayoutKind::Star).value();
}

LayoutPlan oGrid() {
  return planLayout(finished(circleOn(plane(), 1.0)), LayoutKind::OGrid).value();
}

std::multiset<int> usesByStrip(const Strips& strips) {
  std::map<int, int> count;
  for (const auto& uses : strips.uses)
    for (const StripUse& use : uses) ++count[use.strip];
  std::multiset<int> result;
  for (const auto& [strip, uses] : count) result.insert(uses);
  return result;
}

TEST(QuadMesh, AStarHasAStripPerSpokePassedByTwoPatches) {
  for (const int n : {3, 5, 6, 8}) {
    const Strips strips = stripsOf(star(n).mesh);
    EXPECT_EQ(strips.count, n);
    for (const int uses : usesByStrip(strips)) EXPECT_EQ(uses, 2);
  }
}

TEST(QuadMesh, AnOGridHasOneStripAroundAndTwoThrough) {
  const Strips strips = stripsOf(oGrid().mesh);
  EXPECT_EQ(strips.count, 3);
  EXPECT_THAT(usesByStrip(strips), ::testing::ElementsAre(3, 3, 4));
}

TEST(QuadMesh, SeamsRunBackwardsInTheSecondQuad) {
  for (const QuadMesh& mesh : {star(5).mesh, oGrid().mesh}) {
    for (const QuadSeam& seam : mesh.seams()) {
      const auto ends = [&](const QuadEdge& e) {
        const auto& vertices = mesh.quads[static_cast<std::size_t>(e.quad)].vertices;
        const auto k = static_cast<std::size_t>(e.edge);
        return std::pair{vertices[k], vertices[(k + 1) % 4]};
      };
      EXPECT_EQ(ends(seam.first), std::pair(seam.start, seam.end));
      EXPECT_EQ(ends(seam.second), std::pair(seam.end, seam.start));
    }
  }
}

// Knots with no symmetry, another vector a strip: only the right parity makes both sides agree.
TEST(QuadMesh, ParityMakesTheKnotsOfASeamAgreeFromBothSides) {
  for (const LayoutPlan& plan : {star(3), star(6), oGrid()}) {
    std::vector<spline::KnotVector> knots;
    for (int k = 0; k < stripsOf(plan.mesh).count; ++k)
      knots.push_back(spline::KnotVector::fromBreaks(5, {0.0, 0.1 + 0.03 * k, 0.35, 1.0}));
    const PatchLayout layout = buildLayout(plan, knots);
    ASSERT_FALSE(layout.seams.empty());
    for (const Seam& seam : layout.seams) {
      const auto& first = layout.patches[static_cast<std::size_t>(seam.first)];
      const auto& second = layout.patches[static_cast<std::size_t>(seam.second)];
      const auto a = edgeKnots(first, seam.firstEdge), b = edgeKnots(second, seam.secondEdge);
      const auto breaksA = a.breaks(), breaksB = b.breaks();
      ASSERT_EQ(breaksA.size(), breaksB.size());
      for (std::size_t k = 0; k < breaksA.size(); ++k)
        EXPECT_NEAR(breaksA[k] / a.last(), 1.0 - breaksB[breaksB.size() - 1 - k] / b.last(), 1e-12);
      auto own = edgePoints(first, seam.firstEdge, 0);
      auto other = edgePoints(second, seam.secondEdge, 0);
      EXPECT_EQ(own, std::vector<int>(other.rbegin(), other.rend()));
    }
  }
}

}  // namespace
}  // namespace fairing::layout
