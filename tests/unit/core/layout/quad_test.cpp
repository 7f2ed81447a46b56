// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/quad.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/layout/layouts.h"
#include "support/known_loops.h"
#include "support/matchers.h"
#include "support/random_splines.h"

namespace fairing::layout {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using spline::KnotVector;

PatchLayout layoutOf(const boundary::BoundaryLoop& loop) {
  const auto plan = planLayout(loop, LayoutKind::Quad);
  EXPECT_TRUE(plan.has_value());
  return makeLayout(*plan, {0, 1e-6, 10000});
}

std::vector<KnotVector> knotsOf(const boundary::BoundaryLoop& loop, int degree) {
  return makeLayout(*planLayout(loop, LayoutKind::Quad), {degree, 1e-6, 10000}).stripKnots;
}

boundary::BoundaryLoop splineLoop() {
  Random random{0};
  const KnotVector u = randomKnots(random, 3, 3), v = randomKnots(random, 4, 2);
  return finished(borderOf(randomSurface(random, u, v, 0.05)));
}

const PatchEdge kEdges[] = {PatchEdge::South, PatchEdge::East, PatchEdge::North, PatchEdge::West};

TEST(Quad, SidesGoSouthEastNorthWest) {
  const PatchLayout layout = layoutOf(loopOf(waves(), unitSquare()));
  for (std::size_t k = 0; k < 4; ++k) {
    ASSERT_TRUE(layout.patches[0].edges[k].has_value());
    EXPECT_EQ(layout.patches[0].edges[k]->side, static_cast<int>(k));
  }
}

TEST(Quad, EdgesRunHeadToTailRoundThePatch) {
  const LayoutPatch patch = layoutOf(loopOf(waves(), unitSquare())).patches[0];
  const int nu = patch.u.poleCount(), nv = patch.v.poleCount();
  EXPECT_EQ(edgePoints(patch, PatchEdge::South, 0).front(), 0);
  EXPECT_EQ(edgePoints(patch, PatchEdge::East, 0).front(), (nu - 1) * nv);
  EXPECT_EQ(edgePoints(patch, PatchEdge::North, 0).front(), nu * nv - 1);
  EXPECT_EQ(edgePoints(patch, PatchEdge::West, 0).front(), nv - 1);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_EQ(edgePoints(patch, kEdges[k], 0).back(),
              edgePoints(patch, kEdges[(k + 1) % 4], 0).front());
}

TEST(Quad, InnerRowLiesOneInside) {
  const LayoutPatch patch = layoutOf(loopOf(waves(), unitSquare())).patches[0];
  const int nu = patch.u.poleCount(), nv = patch.v.poleCount();
  EXPECT_EQ(edgePoints(patch, PatchEdge::South, 1).front(), 1);
  EXPECT_EQ(edgePoints(patch, PatchEdge::East, 1).front(), (nu - 2) * nv);
  EXPECT_EQ(edgePoints(patch, PatchEdge::North, 1).front(), nu * nv - 2);
  EXPECT_EQ(edgePoints(patch, PatchEdge::West, 1).front(), nv + nv - 1);
}

TEST(Quad, EdgeCurvesFollowTheSidesInTheDirectionOfTheLoop) {
  for (const auto& loop : {loopOf(waves(), unevenQuadrilateral(), 0.1), splineLoop()}) {
    const LayoutPatch patch = layoutOf(loop).patches[0];
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& curve = patch.edges[k]->curve;
      // Mirrored twice: the last bit may differ.
      EXPECT_THAT(
          curve.knots.knots(),
          ::testing::Pointwise(::testing::DoubleNear(1e-14), edgeKnots(patch, kEdges[k]).knots()));
      for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0})
        // The fit was asked for 1e-6; its own check points may miss the worst place by a little.
        EXPECT_THAT(
            curve.evaluate(curve.knots.first() + t * (curve.knots.last() - curve.knots.first())),
            IsNear(loop.sides[k].ribbon.curve(t).point, 2e-6));
    }
  }
}

TEST(Quad, PolynomialSidesAreTakenOverExactly) {
  const boundary::BoundaryLoop loop = splineLoop();
  const PatchLayout layout = layoutOf(loop);
  EXPECT_EQ(layout.curveDeviation, 0.0);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& curve = layout.patches[0].edges[k]->curve;
    for (const double t : {0.1, 0.37, 0.5, 0.83})
      EXPECT_THAT(curve.evaluate(t * curve.knots.last()),
                  IsNear(loop.sides[k].ribbon.curve(t).point, 1e-13));
  }
}

TEST(Quad, KnotsAreThoseOfBothOppositeSides) {
  Random random{1};
  const KnotVector v = randomKnots(random, 3, 2);
  const auto south = randomSurface(random, KnotVector::fromBreaks(3, {0.0, 0.25, 1.0}), v, 0.05);
  const auto north =
      spline::refinedTo(south, KnotVector::fromBreaks(3, {0.0, 0.25, 1.0}).withKnot(0.6), v);
  Sides sides = borderOf(south);
  sides[2].ribbon.polynomial = borderOf(north)[2].ribbon.polynomial;
  const auto knots = knotsOf(finished(sides), 3);
  EXPECT_THAT(knots[0].breaks(), ::testing::ElementsAre(0.0, 0.25, 0.6, 1.0));
  EXPECT_EQ(knots[1].breaks(), v.breaks());
}

TEST(Quad, DomainHasTheHolesProportionsAndUnitArea) {
  const LayoutPatch patch = layoutOf(loopOf(plane(), rectangle(0.0, 8.0, 0.0, 1.0))).patches[0];
  EXPECT_NEAR(patch.u.last() / patch.v.last(), 8.0, 1e-10);
  EXPECT_NEAR(patch.u.last() * patch.v.last(), 1.0, 1e-12);
}

TEST(Quad, NeighbouringEdgesShareTheirCorner) {
  Sides sides = sidesOf(plane(), unitSquare());
  sides[2] = sideOn(plane(), line({1.0, 1.0 + 1e-4}, {0.0, 1.0}), 2);
  const LayoutPatch patch = layoutOf(finished(sides)).patches[0];
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& before = patch.edges[k]->curve.poles;
    const auto& after = patch.edges[(k + 1) % 4]->curve.poles;
    EXPECT_EQ(before.row(before.rows() - 1), after.row(0));
  }
  EXPECT_NEAR(patch.edges[1]->curve.poles.bottomRows(1)(0, 1), 1.0 + 0.5e-4, 1e-12);
}

TEST(Quad, RefiningAddsTheWishedKnotsAndKeepsTheCurves) {
  const boundary::BoundaryLoop loop = splineLoop();
  const PatchLayout coarse = layoutOf(loop);
  const LayoutPatch& before = coarse.patches[0];
  const double wish = 0.4 * before.u.last();
  const PatchLayout fine =
      refineLayout(*planLayout(loop, LayoutKind::Quad), coarse, {{{wish}, {}}});
  const LayoutPatch& after = fine.patches[0];
  EXPECT_EQ(after.u.poleCount(), before.u.poleCount() + 1);
  EXPECT_EQ(after.v.poleCount(), before.v.poleCount());
  for (const double t : {0.1, 0.5, 0.8})
    EXPECT_THAT(after.edges[0]->curve.evaluate(t * after.u.last()),
                IsNear(before.edges[0]->curve.evaluate(t * before.u.last()), 1e-13));
}

TEST(Quad, EveryPoleHasItsOwnPoint) {
  const PatchLayout layout = layoutOf(loopOf(waves(), unitSquare()));
  const LayoutPatch& patch = layout.patches[0];
  EXPECT_EQ(layout.pointCount, patch.u.poleCount() * patch.v.poleCount());
  std::vector<int> sorted = patch.points;
  std::sort(sorted.begin(), sorted.end());
  for (int k = 0; k < layout.pointCount; ++k) EXPECT_EQ(sorted[static_cast<std::size_t>(k)], k);
}

TEST(Quad, DegreeAskedForIsTheDegreeTaken) {
  for (const int degree : {3, 4, 7, 9}) {
    for (const KnotVector& knots : knotsOf(loopOf(plane(), unitSquare()), degree))
      EXPECT_EQ(knots.degree(), degree);
  }
}

TEST(Quad, DegreeIsNeverBelowTheEdges) {
  const auto knots = knotsOf(splineLoop(), 3);
  EXPECT_EQ(knots[0].degree(), 3);
  EXPECT_EQ(knots[1].degree(), 4);
}

}  // namespace
}  // namespace fairing::layout
