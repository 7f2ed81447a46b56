// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/read_boundary.h"

#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "occt/find_holes.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using boundary::BoundaryLoop;
using boundary::BoundarySide;
using Eigen::Matrix3d;
using Eigen::Vector3d;

BoundaryLoop holeOf(const TopoDS_Shape& shape) {
  const ShapeIndex index(shape);
  auto loop = readBoundary(index, {.edges = innerFreeEdges(index)});
  EXPECT_TRUE(loop.has_value()) << (loop ? 0 : int(loop.error().code));
  return loop ? *loop : BoundaryLoop{};
}

/// What a point of an analytic surface has: outward normal, and the shape operator -dn.
struct Analytic {
  Vector3d normal;
  Matrix3d secondForm;
};

template <class Surface>
void expectSupports(const BoundaryLoop& loop,
                    const Surface& surface,
                    double sense,
                    double tolerance) {
  ASSERT_EQ(loop.sides.size(), 4u);
  for (const BoundarySide& side : loop.sides) {
    ASSERT_TRUE(side.ribbon.hasSupport());
    for (double t : {0.0, 0.13, 0.5, 0.77, 1.0}) {
      const auto support = side.ribbon.support(t);
      const Analytic truth = surface(side.ribbon.curve(t).point);
      EXPECT_FALSE(support.singular);
      EXPECT_LT((support.point - side.ribbon.curve(t).point).norm(), tolerance);
      EXPECT_LT((support.normal - sense * truth.normal).norm(), tolerance);
      EXPECT_LT((support.secondForm - sense * truth.secondForm).norm(), tolerance);
    }
  }
}

Analytic sphereAt(const Vector3d& p) {
  const Vector3d n = p.normalized();
  return {n, -(Matrix3d::Identity() - n * n.transpose()) / p.norm()};
}

Analytic cylinderAt(const Vector3d& p) {
  const Vector3d radial(p.x(), p.y(), 0.0);
  const Vector3d around(-p.y(), p.x(), 0.0);
  return {radial.normalized(),
          -around.normalized() * around.normalized().transpose() / radial.norm()};
}

constexpr double kMajor = 20.0;
constexpr double kMinor = 6.0;

Analytic torusAt(const Vector3d& p) {
  const Vector3d centre = Vector3d(p.x(), p.y(), 0.0).normalized() * kMajor;
  const Vector3d n = (p - centre).normalized();
  const Vector3d around = Vector3d(-p.y(), p.x(), 0.0).normalized();
  const Vector3d meridian = n.cross(around);
  const double rho = Vector3d(p.x(), p.y(), 0.0).norm();
  const double cosine = (rho - kMajor) / kMinor;
  return {n,
          -around * around.transpose() * cosine / rho - meridian * meridian.transpose() / kMinor};
}

const std::vector<double> kAngles{0.2, 0.7, 1.2, 1.7};

TopoDS_Shape sphere() {
  return grid(new Geom_SphericalSurface(gp_Ax3(), 12.0), kAngles, {-0.6, -0.1, 0.4, 0.9}, {{1, 1}});
}
TopoDS_Shape cylinder() {
  return grid(new Geom_CylindricalSurface(gp_Ax3(), 7.0), kAngles, {0, 4, 9, 15}, {{1, 1}});
}
TopoDS_Shape torus() {
  return grid(
      new Geom_ToroidalSurface(gp_Ax3(), kMajor, kMinor), kAngles, {1.0, 1.5, 2.1, 2.8}, {{1, 1}});
}

TEST(ReadBoundary, GivesTheNormalsAndCurvatureOfAnalyticFaces) {
  expectSupports(holeOf(sphere()), sphereAt, 1.0, 1e-9);
  expectSupports(holeOf(cylinder()), cylinderAt, 1.0, 1e-9);
  expectSupports(holeOf(torus()), torusAt, 1.0, 1e-9);
}

TEST(ReadBoundary, RespectsTheOrientationOfFaces) {
  expectSupports(holeOf(torus().Reversed()), torusAt, -1.0, 1e-9);
}

TEST(ReadBoundary, FollowsLocations) {
  gp_Trsf motion;
  motion.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -2, 0.5)), 0.8);
  motion.SetTranslationPart(gp_Vec(100, -50, 7));
  const BoundaryLoop moved = holeOf(torus().Moved(TopLoc_Location(motion)));
  const BoundaryLoop still = holeOf(torus());
  ASSERT_EQ(edgesOf(moved), edgesOf(still));
  Matrix3d rotation;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rotation(i, j) = motion.Value(i + 1, j + 1);
  }
  const Vector3d shift(
      motion.TranslationPart().X(), motion.TranslationPart().Y(), motion.TranslationPart().Z());
  for (std::size_t k = 0; k < 4; ++k) {
    for (double t : {0.0, 0.4, 1.0}) {
      const auto a = still.sides[k].ribbon.support(t);
      const auto b = moved.sides[k].ribbon.support(t);
      EXPECT_LT((rotation * a.point + shift - b.point).norm(), 1e-10);
      EXPECT_LT((rotation * a.normal - b.normal).norm(), 1e-10);
      EXPECT_LT((rotation * a.secondForm * rotation.transpose() - b.secondForm).norm(), 1e-10);
    }
  }
}

TEST(ReadBoundary, RunsHeadToTailWithTheHoleToTheLeft) {
  for (const TopoDS_Shape& shape :
       {sphere(), cylinder(), torus(), sheetWithHole(), torus().Reversed()}) {
    const BoundaryLoop loop = holeOf(shape);
    ASSERT_EQ(loop.sides.size(), 4u);
    Vector3d middle = Vector3d::Zero();
    for (const auto& side : loop.sides) middle += side.ribbon.curve(0.0).point / 4.0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& side = loop.sides[k].ribbon;
      EXPECT_LT((side.curve(1.0).point - loop.sides[(k + 1) % 4].ribbon.curve(0.0).point).norm(),
                1e-6);
      const Vector3d left = side.support(0.5).normal.cross(side.curve(0.5).derivative);
      EXPECT_GT(left.dot(middle - side.curve(0.5).point), 0.0);
    }
  }
}

TEST(ReadBoundary, IsTheSameForEveryOrderOfPicks) {
  const ShapeIndex index(sheetWithHole());
  std::vector<int> picks = innerFreeEdges(index);
  const auto reference = readBoundary(index, {.edges = picks});
  ASSERT_TRUE(reference.has_value());
  std::sort(picks.begin(), picks.end());
  do {
    const auto loop = readBoundary(index, {.edges = picks});
    ASSERT_TRUE(loop.has_value());
    ASSERT_EQ(edgesOf(*loop), edgesOf(*reference));
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(loop->sides[k].ribbon.curve(0.3).point,
                reference->sides[k].ribbon.curve(0.3).point);
    }
  } while (std::next_permutation(picks.begin(), picks.end()));
}

TEST(ReadBoundary, TurnsTheNormalsOfFacesOrientedAgainstTheOthers) {
  const ShapeIndex index(everySecondReversed(sphere()));
  const auto loop = readBoundary(index, {.edges = innerFreeEdges(index)});
  ASSERT_TRUE(loop.has_value());
  const double sense =
      loop->sides[0].ribbon.support(0.5).normal.dot(loop->sides[0].ribbon.curve(0.5).point) > 0.0
          ? 1.0
          : -1.0;
  expectSupports(*loop, sphereAt, sense, 1e-9);
}

TEST(ReadBoundary, TakesPolynomialEdgesExactly) {
  const BoundaryLoop loop = holeOf(sheetWithHole());
  for (const BoundarySide& side : loop.sides) {
    ASSERT_TRUE(side.ribbon.polynomial.has_value());
    EXPECT_EQ(side.ribbon.polynomial->knots.first(), 0.0);
    EXPECT_EQ(side.ribbon.polynomial->knots.last(), 1.0);
    for (double t : {0.0, 0.01, 0.3, 0.62, 0.99, 1.0}) {
      const auto sample = side.ribbon.curve(t);
      EXPECT_LT((side.ribbon.polynomial->evaluate(t) - sample.point).norm(), 1e-12 * loop.diagonal);
      EXPECT_LT((side.ribbon.polynomial->evaluate(t, 1) - sample.derivative).norm(),
                1e-10 * loop.diagonal);
    }
  }
}

TEST(ReadBoundary, LeavesArcsToBeFitted) {
  for (const BoundarySide& side : holeOf(torus()).sides)
    EXPECT_FALSE(side.ribbon.polynomial.has_value());
}

TEST(ReadBoundary, DerivativesAreThoseOfTheCurve) {
  for (const BoundarySide& side : holeOf(torus()).sides) {
    for (double t : {0.1, 0.5, 0.9}) {
      const double h = 1e-5;
      const Vector3d slope =
          (side.ribbon.curve(t + h).point - side.ribbon.curve(t - h).point) / (2.0 * h);
      EXPECT_LT((slope - side.ribbon.curve(t).derivative).norm(), 1e-7);
    }
  }
}

TEST(ReadBoundary, FindsTheSupportOfALooseTwin) {
  // The picked face's border edges are its own; the staying faces have coincident ones.
  const ShapeIndex index(grid(new Geom_SphericalSurface(gp_Ax3(), 12.0),
                              kAngles,
                              {-0.6, -0.1, 0.4, 0.9},
                              {},
                              Joint::Loose));
  const auto loop = readBoundary(index, {.faces = {5}});
  ASSERT_TRUE(loop.has_value()) << int(loop.error().code);
  expectSupports(*loop, sphereAt, 1.0, 1e-7);
  for (const BoundarySide& side : loop->sides) EXPECT_NE(side.face, 5);
}

TEST(ReadBoundary, TakesTheStayingFaceBesideAPickedOne) {
  const ShapeIndex index(box(10, 20, 30));
  for (int face = 1; face <= 6; ++face) {
    const auto loop = readBoundary(index, {.faces = {face}});
    ASSERT_TRUE(loop.has_value());
    for (const BoundarySide& side : loop->sides) {
      EXPECT_NE(side.face, face);
      EXPECT_NE(side.face, 0);
      // The faces of a box stand on each other: the support's normal points away from the picked
      // face's side.
      const Vector3d outward = side.ribbon.support(0.5).normal;
      EXPECT_GT(outward.dot(side.ribbon.curve(0.5).point - Vector3d(5, 10, 15)), 0.0);
    }
  }
}

TEST(ReadBoundary, MeetsLoneEdgesInPositionUnlessToldOtherwise) {
  TopoDS_Shape sheet = grid(new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)),
                            {0, 10, 20, 30},
                            {0, 10, 20, 30},
                            {{1, 1}, {1, 2}});
  const ShapeIndex index(
      compound({sheet, BRepBuilderAPI_MakeEdge(gp_Pnt(10, 20, 0), gp_Pnt(20, 20, 0)).Shape()}));
  const int lone = edgesNear(index, {{15, 20, 0}}).front();
  const auto loop = readBoundary(index, {.edges = {lone}});
  ASSERT_TRUE(loop.has_value());
  for (const BoundarySide& side : loop->sides) {
    EXPECT_EQ(side.continuity, side.edge == lone ? Continuity::G0 : Continuity::G1);
    EXPECT_EQ(side.ribbon.hasSupport(), side.edge != lone);
  }
  const auto forced =
      readBoundary(index, {.edges = {lone}, .edgeContinuity = {{lone, Continuity::G1}}});
  ASSERT_FALSE(forced.has_value());
  EXPECT_EQ(forced.error().code, ErrorCode::EdgeWithoutFace);
  EXPECT_EQ(forced.error().edge, lone);
}

TEST(ReadBoundary, PassesWishesOnAndRefusesThoseForOtherEdges) {
  const ShapeIndex index(sheetWithHole());
  const std::vector<int> edges = innerFreeEdges(index);
  const auto loop =
      readBoundary(index, {.edges = edges, .edgeContinuity = {{edges[2], Continuity::G0}}});
  ASSERT_TRUE(loop.has_value());
  for (const BoundarySide& side : loop->sides) {
    EXPECT_EQ(side.continuity, side.edge == edges[2] ? Continuity::G0 : Continuity::G1);
  }
  const int other = edges.front() == 1 ? 2 : 1;
  const auto refused =
      readBoundary(index, {.edges = edges, .edgeContinuity = {{other, Continuity::G0}}});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::EdgeNotInLoop);
}

TEST(ReadBoundary, TakesTheLimitOfTheNormalAtAPole) {
  // A sphere's cap below the pole, split at a meridian: the pole is an end of both free meridians.
  const Handle(Geom_Surface) surface = new Geom_SphericalSurface(gp_Ax3(), 10.0);
  const ShapeIndex index(
      BRepBuilderAPI_MakeFace(surface, 0.3, 1.4, 0.5, std::numbers::pi / 2, 1e-7).Shape());
  const std::vector<Hole> holes = findHoles(index);
  ASSERT_EQ(holes.size(), 1u);
  const auto loop = readBoundary(index, {.edges = holes[0].edges});
  ASSERT_TRUE(loop.has_value());
  int poles = 0;
  for (const BoundarySide& side : loop->sides) {
    for (double t : {0.0, 1.0}) {
      if ((side.ribbon.curve(t).point - Vector3d(0, 0, 10)).norm() > 1e-6) continue;
      ++poles;
      const auto support = side.ribbon.support(t);
      EXPECT_FALSE(support.singular);
      EXPECT_LT((support.normal - Vector3d::UnitZ()).norm(), 1e-6);
    }
  }
  EXPECT_EQ(poles, 2);
}

TEST(ReadBoundary, TakesTheEdgeForPositionAndTheFaceForNormalsAndTellsTheirDistance) {
  const TopoDS_Shape shape = cylinder();
  const ShapeIndex index(shape);
  const std::vector<int> edges = innerFreeEdges(index);
  constexpr double kOff = 0.002;
  int moved = 0;
  for (int edge : edges) {
    double first, last;
    const Handle(Geom_Line) line =
        Handle(Geom_Line)::DownCast(BRep_Tool::Curve(index.edge(edge), first, last));
    if (line.IsNull() || moved > 0) continue;
    const gp_Pnt at = line->Value(first);
    const gp_Vec outward = gp_Vec(at.X(), at.Y(), 0.0).Normalized() * kOff;
    BRep_Builder().UpdateEdge(
        index.edge(edge), Handle(Geom_Curve)::DownCast(line->Translated(outward)), 2.0 * kOff);
    moved = edge;
  }
  ASSERT_GT(moved, 0);
  const auto loop = readBoundary(index, {.edges = edges});
  ASSERT_TRUE(loop.has_value());
  for (const BoundarySide& side : loop->sides) {
    EXPECT_NEAR(side.supportDeviation, side.edge == moved ? kOff : 0.0, 1e-9);
    if (side.edge != moved) continue;
    const Vector3d p = side.ribbon.curve(0.4).point;
    EXPECT_NEAR(p.head<2>().norm(), 7.0 + kOff, 1e-9);
    EXPECT_LT((side.ribbon.support(0.4).normal - cylinderAt(p).normal).norm(), 1e-9);
    EXPECT_NEAR(side.ribbon.support(0.4).point.head<2>().norm(), 7.0, 1e-9);
  }
}

}  // namespace
}  // namespace fairing::occt
