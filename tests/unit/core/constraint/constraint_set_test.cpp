// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/constraint_set.h"

#include <gmock/gmock.h>

#include "core/assembly/assemble_energy.h"
#include "core/boundary/constraint_normal.h"
#include "core/layout/layouts.h"
#include "core/solver/solve.h"
#include "support/known_loops.h"
#include "support/matchers.h"

namespace fairing::constraint {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using boundary::BoundaryLoop;
using Eigen::Vector3d;

// The thin plate under a loop's constraints on its coarsest knots, with one inner knot a direction.
struct Plate {
  layout::PatchLayout layout;
  solver::Solution solution;
  spline::BsplineSurface patch;
};

Plate plateOn(const BoundaryLoop& loop) {
  Plate plate;
  const auto plan = layout::planLayout(loop, LayoutKind::Quad);
  const auto coarse = layout::makeLayout(*plan, {5, 1e-8 * loop.diagonal, 10000});
  const auto& first = coarse.patches[0];
  plate.layout =
      layout::refineLayout(*plan, coarse, {{{0.45 * first.u.last()}, {0.55 * first.v.last()}}});
  const ConstraintSet set = *constrainSides(loop, plate.layout);
  solver::QuadraticProgram program;
  program.stiffness = assembly::assembleEnergy(plate.layout, energy::thinPlate());
  program.fixed = set.fixed;
  program.values = set.values;
  program.blocks = set.blocks;
  plate.solution = *solver::solve(program);
  plate.patch = {plate.layout.patches[0].u, plate.layout.patches[0].v, plate.solution.points};
  return plate;
}

// South: u along, v across. The side's parameter is affine in u.
double tiltOnSouth(const BoundaryLoop& loop, const spline::BsplineSurface& patch, double u) {
  const Vector3d n = constraintNormal(loop.sides[0].ribbon, u / patch.u.last());
  return patch.evaluate(u, 0.0, 0, 1).dot(n);
}

TEST(ConstrainSides, OuterRowIsTheSidesCurve) {
  const BoundaryLoop loop = loopOf(waves(), unevenQuadrilateral(), 0.05);
  const Plate plate = plateOn(loop);
  const auto& p = plate.patch;
  for (const double t : {0.0, 0.3, 0.6, 1.0}) {
    const double tolerance = 2e-8 * loop.diagonal;  // of the fit, twice
    EXPECT_THAT(p.evaluate(t * p.u.last(), 0.0),
                IsNear(loop.sides[0].ribbon.curve(t).point, tolerance));
    EXPECT_THAT(p.evaluate(p.u.last(), t * p.v.last()),
                IsNear(loop.sides[1].ribbon.curve(t).point, tolerance));
    EXPECT_THAT(p.evaluate((1.0 - t) * p.u.last(), p.v.last()),
                IsNear(loop.sides[2].ribbon.curve(t).point, tolerance));
    EXPECT_THAT(p.evaluate(0.0, (1.0 - t) * p.v.last()),
                IsNear(loop.sides[3].ribbon.curve(t).point, tolerance));
  }
}

TEST(ConstrainSides, CrossTangentIsInTheTangentPlaneAtTheSites) {
  const BoundaryLoop loop = loopOf(waves(), unevenQuadrilateral(), 0.05);
  const Plate plate = plateOn(loop);
  const auto& knots = plate.patch.u;
  for (int i = 2; i < knots.poleCount() - 2; ++i)
    EXPECT_NEAR(tiltOnSouth(loop, plate.patch, knots.greville(i)), 0.0, 1e-11);
}

TEST(ConstrainSides, TiltHasADoubleZeroAtCompatibleCorners) {
  const BoundaryLoop loop = loopOf(waves(), unevenQuadrilateral(), 0.05);
  const Plate plate = plateOn(loop);
  const double width = plate.patch.u.last(), h = 1e-3 * width;
  // The value: end tangents of the fitted sides are exact. The slope: twists are.
  EXPECT_NEAR(tiltOnSouth(loop, plate.patch, 0.0), 0.0, 1e-12);
  EXPECT_NEAR(tiltOnSouth(loop, plate.patch, width), 0.0, 1e-12);
  // A double zero leaves h^2 times second derivatives of about 1 where a simple one leaves h.
  EXPECT_NEAR(tiltOnSouth(loop, plate.patch, h), 0.0, 3.0 * h * h);
  EXPECT_NEAR(tiltOnSouth(loop, plate.patch, width - h), 0.0, 3.0 * h * h);
}

TEST(ConstrainSides, IncompatibleTwistsAreSharedByBothSides) {
  // Both sides of a corner bear half of the mismatch, as a slope of the tilt with opposite signs.
  const BoundaryLoop loop = finished(incompatibleTwists(0.2));
  const Plate plate = plateOn(loop);
  const double h = 1e-3;
  const double atStart = tiltOnSouth(loop, plate.patch, h) / h;
  const double atEnd = -tiltOnSouth(loop, plate.patch, plate.patch.u.last() - h) / h;
  EXPECT_NEAR(std::abs(atStart), 0.1, 0.01);
  EXPECT_NEAR(std::abs(atEnd), 0.1, 0.01);
}

TEST(ConstrainSides, G0SidesLeaveTheInnerRowFree) {
  Sides sides = sidesOf(waves(), unitSquare());
  for (auto& side : sides) side.continuity = Continuity::G0;
  const BoundaryLoop loop = finished(sides);
  const auto plan = layout::planLayout(loop, LayoutKind::Quad);
  const auto set = constrainSides(loop, layout::makeLayout(*plan, {5, 1e-6, 1000}));
  ASSERT_TRUE(set.has_value());
  EXPECT_TRUE(set->blocks.empty());
}

TEST(ConstrainSides, ConstraintsOfOneSmoothSupportDoNotContradictEachOther) {
  EXPECT_LT(plateOn(loopOf(waves(), unevenQuadrilateral(), 0.05)).solution.residual, 1e-10);
}

TEST(ConstrainSides, ASupportWithoutNormalIsReported) {
  Sides sides = sidesOf(waves(), unitSquare());
  sides[1].ribbon.support = [](double) {
    boundary::SupportSample s;
    s.singular = true;
    return s;
  };
  boundary::BoundaryLoop loop;
  loop = loopOf(waves(), unitSquare());
  loop.sides[1].ribbon.support = sides[1].ribbon.support;
  const auto plan = layout::planLayout(loop, LayoutKind::Quad);
  const auto set = constrainSides(loop, layout::makeLayout(*plan, {5, 1e-6, 1000}));
  ASSERT_THAT(set, FailsWith(ErrorCode::SupportNormalSingular));
  EXPECT_EQ(set.error().edge, loop.sides[1].edge);
}

}  // namespace
}  // namespace fairing::constraint
