// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepCheck_Analyzer.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <cmath>
#include <numbers>

#include "occt/blends.h"
#include "occt/from_occt.h"
#include "occt/shapes.h"

// Blends round a vertex: open chains with gaps between them.
namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;

constexpr double kRound = 2.0 * std::numbers::pi;

/// Faces with a border each that a blend is to join: points of these.
struct Faces {
  std::vector<TopoDS_Shape> faces;
  std::vector<Vector3d> borders;

  [[nodiscard]] TopoDS_Shape shape() const { return compound(faces); }
};

BlendPicks ringOf(const TopoDS_Shape& shape, const std::vector<Vector3d>& borders) {
  const auto edges = edgesNear(ShapeIndex(shape), borders);
  return {.from = {edges.front()}, .to = {edges.begin() + 1, edges.end()}, .ring = true};
}

ShapeFill joined(const Faces& faces, ResultMode mode = ResultMode::Patches) {
  const TopoDS_Shape shape = faces.shape();
  return blended(shape, ringOf(shape, faces.borders), mode);
}

/// Pieces of a sphere about its pole, from 30 degrees of latitude to 50, that leave a tenth of the
/// way round free between them.
Faces piecesOfSphere(double radius, int count) {
  const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(upright(), radius);
  Faces result;
  for (int k = 0; k < count; ++k) {
    const double from = kRound * k / count, to = from + kRound * 0.9 / count;
    const double low = kRound / 12.0, high = kRound * 5.0 / 36.0;
    result.faces.push_back(grid(sphere, {from, to}, {low, high}, {}, Joint::Loose));
    result.borders.push_back(fromOcct(sphere->Value(0.5 * (from + to), high)));
  }
  return result;
}

/// Arched strips that come in from three sides, on axes that are not in one plane: fillets that end
/// before the vertex where they would meet.
Faces fillets() {
  Faces result;
  for (int k = 0; k < 3; ++k) {
    const double turn = kRound * k / 3.0;
    const gp_Dir along(std::cos(turn), std::sin(turn), -0.5);
    const gp_Dir side(-std::sin(turn), std::cos(turn), 0.0);
    const gp_Dir up = along.Crossed(side);
    const gp_Pnt start(4.0 * along.X(), 4.0 * along.Y(), 4.0 * along.Z() + 5.0 * up.Z());
    const Handle(Geom_Surface) arch = new Geom_CylindricalSurface(gp_Ax3(start, along, side), 5.0);
    const double middle = up.Dot(gp_Dir(0, 0, 1)) > 0.0 ? 0.25 * kRound : 0.75 * kRound;
    result.faces.push_back(grid(arch, {middle - 0.5, middle + 0.5}, {6.0, 12.0}, {}, Joint::Loose));
    result.borders.push_back(fromOcct(arch->Value(middle, 6.0)));
  }
  return result;
}

TEST(BlendRing, JoinsFilletsTangentially) {
  const ShapeFill blend = joined(fillets());
  EXPECT_EQ(blend.fill.layout, LayoutKind::Junction);
  EXPECT_EQ(blend.fill.patches.size(), 6U);
  expectWithin(blend);
}

// The gradient of the mean curvature, which is made small, vanishes on a sphere.
TEST(BlendRing, OfPiecesOfASphereLiesOnIt) {
  for (const int count : {3, 4}) {
    const ShapeFill blend = joined(piecesOfSphere(10.0, count));
    expectWithin(blend);
    for (const Vector3d& p : pointsOf(blend, 4))
      EXPECT_NEAR(p.norm(), 10.0, 1e-3 * blend.fill.report.diagonal);
  }
}

TEST(BlendRing, OfCoplanarFacesIsPlane) {
  Faces faces;
  for (int k = 0; k < 3; ++k) {
    const double turn = kRound * k / 3.0;
    const gp_Dir out(std::cos(turn), std::sin(turn), 0.0);
    const Handle(Geom_Surface) plane =
        new Geom_Plane(gp_Ax3(gp_Pnt(0, 0, 2), gp_Dir(0, 0, 1), out));
    faces.faces.push_back(grid(plane, {5.0, 9.0}, {-3.0 + k, 3.0}, {}, Joint::Loose));
    faces.borders.push_back(fromOcct(plane->Value(5.0, 0.5 * k)));
  }
  const ShapeFill blend = joined(faces);
  expectWithin(blend);
  for (const Vector3d& p : pointsOf(blend, 4)) EXPECT_NEAR(p.z(), 2.0, 1e-9);
}

TEST(BlendRing, DoesNotDependOnOrderNorOnOrientation) {
  const Faces faces = fillets();
  const ShapeFill one = joined(faces);
  const double limit = 1e-6 * one.fill.report.diagonal;
  const Faces other{faces.faces, {faces.borders[2], faces.borders[1], faces.borders[0]}};
  EXPECT_LT(apart(one, joined(other)), limit);
  const TopoDS_Shape turned = everySecondReversed(faces.shape());
  EXPECT_LT(apart(one, blended(turned, ringOf(turned, faces.borders))), limit);
}

// A chain with a corner counts as two sides that touch.
TEST(BlendRing, TakesChainsThatTouch) {
  Faces faces;
  const Handle(Geom_Surface) waved = wavedSheet();
  const auto face = [&](double u, double v, double width, double height) {
    return grid(waved, {u, u + width}, {v, v + height}, {}, Joint::Loose);
  };
  const TopoDS_Shape bent = grid(waved, {0.0, 0.3, 0.6}, {0.0, 0.3, 0.6}, {{1, 1}});
  faces.faces = {bent, face(0.8, 0.4, 0.2, 0.35), face(0.4, 0.8, 0.35, 0.2)};
  const TopoDS_Shape shape = faces.shape();
  std::vector<Vector3d> middles;
  for (const auto& [u, v] : {std::pair{0.3, 0.45}, {0.45, 0.3}, {0.8, 0.575}, {0.575, 0.8}})
    middles.push_back(fromOcct(waved->Value(u, v)));
  const auto edges = edgesNear(ShapeIndex(shape), middles);
  const ShapeFill blend =
      blended(shape, {.from = {edges[0], edges[1]}, .to = {edges[2], edges[3]}, .ring = true});
  EXPECT_EQ(blend.fill.patches.size(), 7U);
  expectWithin(blend);
  // The chain it starts from is held by the first one, also where another one touches its start.
  for (const auto& [from, other] : {std::pair{edges[0], edges[1]}, {edges[1], edges[0]}}) {
    const ShapeFill same =
        blended(shape, {.from = {from}, .to = {other, edges[2], edges[3]}, .ring = true});
    EXPECT_LT(apart(blend, same), 1e-6 * blend.fill.report.diagonal);
    EXPECT_THAT((std::vector{same.loop.sides[0].edge, same.loop.sides[1].edge}),
                ::testing::UnorderedElementsAre(edges[0], edges[1]));
  }
}

TEST(BlendRing, SewsToItsFaces) {
  const ShapeFill blend = joined(fillets(), ResultMode::Base);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
}

TEST(BlendRing, IsMadeWhereAskedForOnly) {
  const Faces faces = fillets();
  const TopoDS_Shape shape = faces.shape();
  BlendPicks picks = ringOf(shape, faces.borders);
  picks.ring = false;
  EXPECT_EQ(refusal(shape, picks), ErrorCode::ChainBroken);
}

TEST(BlendRing, HasNoCuts) {
  const Faces faces = fillets();
  const TopoDS_Shape shape = faces.shape();
  BlendPicks picks = ringOf(shape, faces.borders);
  picks.cuts = {1};
  EXPECT_EQ(refusal(shape, picks), ErrorCode::CutUnfit);
}

}  // namespace
}  // namespace fairing::occt
