// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "occt/blends.h"
#include "occt/from_occt.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using boundary::MatchKind;
using Eigen::Vector3d;

/// A box of given half widths about the z-axis without lid and bottom.
TopoDS_Shape frame(double x, double y, double low, double high) {
  const std::vector<Vector3d> corners{{x, y, 0}, {-x, y, 0}, {-x, -y, 0}, {x, -y, 0}};
  std::vector<TopoDS_Shape> faces;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector3d &a = corners[k], &b = corners[(k + 1) % 4], up = Vector3d::UnitZ();
    faces.push_back(polygon({a + low * up, b + low * up, b + high * up, a + high * up}));
  }
  return compound(faces);
}

/// Middles of the rim of a frame at a height.
std::vector<Vector3d> rim(double x, double y, double z) {
  return {{x, 0, z}, {0, y, z}, {-x, 0, z}, {0, -y, z}};
}

TopoDS_Shape twoFrames() {
  return compound({frame(10, 8, 0, 10), frame(5, 6, 22, 30)});
}
BlendPicks framePicks() {
  return picksNear(twoFrames(), rim(10, 8, 10), rim(5, 6, 22));
}

/// As one shell.
ShapeFill sewn(const TopoDS_Shape& shape, const BlendPicks& picks) {
  return blended(shape, picks, ResultMode::Shell);
}

void expectTangent(const ShapeFill& blend) {
  const auto& report = blend.fill.report;
  EXPECT_TRUE(report.withinTolerance);
  EXPECT_LT(report.largestAngle, 0.02);
  EXPECT_LT(report.largestCornerAngle, 0.05);
  EXPECT_LT(report.largestGap, 1e-6 * report.diagonal);
  EXPECT_LT(report.largestSeamGap, 1e-9 * report.diagonal);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
}

TEST(BlendCorners, JoinsTwoFramesFaceToFaceByPatchesThatMeetInCreases) {
  const ShapeFill blend = sewn(twoFrames(), framePicks());
  expectTangent(blend);
  ASSERT_EQ(blend.fill.patches.size(), 4U);
  ASSERT_EQ(blend.fill.report.seams.size(), 4U);
  for (const auto& seam : blend.fill.report.seams) EXPECT_TRUE(seam.crease);
  // Both frames have the planes x = 0 and y = 0 of symmetry, and so has the blend.
  const auto top = [&](double sx, double sy) {
    double nearest = 1e9;
    const Vector3d at(sx * 7.0, sy * 7.0, 16.0);
    for (const auto& patch : blend.fill.patches)
      for (int i = 0; i <= 60; ++i)
        for (int j = 0; j <= 60; ++j)
          nearest = std::min(
              nearest,
              (patch.evaluate(patch.u.last() * i / 60, patch.v.last() * j / 60) - at).norm());
    return nearest;
  };
  EXPECT_NEAR(top(1, 1), top(-1, 1), 1e-4);
  EXPECT_NEAR(top(1, 1), top(-1, -1), 1e-4);
}

TEST(BlendCorners, OfFramesMeetCurvatureWhereAsked) {
  BlendPicks picks = framePicks();
  picks.continuity = Continuity::G2;
  const ShapeFill blend = sewn(twoFrames(), picks);
  expectTangent(blend);
  EXPECT_LT(blend.fill.report.largestCurvature, 0.01);
}

TEST(BlendCorners, DoNotDependOnWhichSideIsFirstNorOnTheFacesOrientation) {
  const ShapeFill one = sewn(twoFrames(), framePicks());
  const BlendPicks picks = framePicks();
  const ShapeFill other = sewn(twoFrames(), {.from = picks.to, .to = picks.from});
  const TopoDS_Shape turned = everySecondReversed(twoFrames());
  const ShapeFill third = sewn(turned, picksNear(turned, rim(10, 8, 10), rim(5, 6, 22)));
  const double limit = 1e-6 * one.fill.report.fairness.area;
  EXPECT_NEAR(area(one.shape), area(other.shape), limit);
  EXPECT_NEAR(area(one.shape), area(third.shape), limit);
}

/// An L of two plane faces in one plane z = const, its inner rim at x = s and y = s.
TopoDS_Shape plateL(double near, double far, double z) {
  return compound({polygon({{near, near, z}, {30, near, z}, {30, far, z}, {far, far, z}}),
                   polygon({{near, near, z}, {far, far, z}, {far, 30, z}, {near, 30, z}})});
}

TEST(BlendCorners, OfOneChainInAPlaneGoOnSmoothly) {
  const TopoDS_Shape shape = compound({plateL(0, -5, 0), plateL(4, 10, 6)});
  const ShapeFill blend =
      sewn(shape, picksNear(shape, {{15, 0, 0}, {0, 15, 0}}, {{17, 4, 6}, {4, 17, 6}}));
  expectTangent(blend);
  ASSERT_EQ(blend.fill.report.seams.size(), 1U);
  EXPECT_FALSE(blend.fill.report.seams[0].crease);
  EXPECT_LT(blend.fill.report.seams[0].angle.max, 0.02);
}

TEST(BlendCorners, CutBothSidesWhereOnlyOneHasThem) {
  const TopoDS_Shape smooth = polygon({{-12, 0, 14}, {12, 0, 14}, {12, -10, 14}, {-12, -10, 14}});
  const TopoDS_Shape bent = compound({polygon({{-12, 10, 0}, {0, 12, 0}, {0, 20, 0}, {-12, 20, 0}}),
                                      polygon({{0, 12, 0}, {12, 10, 0}, {12, 20, 0}, {0, 20, 0}})});
  const TopoDS_Shape shape = compound({smooth, bent});
  BlendPicks picks = picksNear(shape, {{0, 0, 14}}, {{-6, 11, 0}, {6, 11, 0}});
  const ShapeFill blend = sewn(shape, picks);
  expectTangent(blend);
  EXPECT_EQ(blend.fill.patches.size(), 2U);
  picks.match = MatchKind::Corners;
  EXPECT_EQ(refusal(shape, picks), ErrorCode::CornersDiffer);
}

TEST(BlendCorners, AlignmentTurnsFramesByACorner) {
  BlendPicks picks = framePicks();
  const ShapeFill plain = sewn(twoFrames(), picks);
  picks.alignment = 0.25;
  const ShapeFill turned = sewn(twoFrames(), picks);
  EXPECT_EQ(plain.fill.matches.size(), 4U);
  for (const auto& [from, to] : plain.fill.matches)
    EXPECT_GT(from.head<2>().dot(to.head<2>()), 0.0);
  // A quarter turn: neither beside its own corner nor across from it.
  for (const auto& [from, to] : turned.fill.matches)
    EXPECT_LT(std::abs(from.head<2>().normalized().dot(to.head<2>().normalized())), 0.5);
  EXPECT_LT(turned.fill.report.largestAngle, 0.02);
}

int vertexNear(const TopoDS_Shape& shape, const Vector3d& point) {
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  int nearest = 1;
  const auto distance = [&](int k) {
    return (fromOcct(BRep_Tool::Pnt(TopoDS::Vertex(vertices(k)))) - point).norm();
  };
  for (int k = 1; k <= vertices.Extent(); ++k)
    if (distance(k) < distance(nearest)) nearest = k;
  return nearest;
}

TEST(BlendCorners, JoinTheVerticesThatAreGiven) {
  const TopoDS_Shape shape = twoFrames();
  const int a = vertexNear(shape, {10, 8, 10}), b = vertexNear(shape, {-5, 6, 22});
  BlendPicks picks = framePicks();
  picks.pairs = {{a, b}};
  const ShapeFill blend = sewn(shape, picks);
  EXPECT_EQ(blend.fill.patches.size(), 4U);
  EXPECT_LT(blend.fill.report.largestAngle, 0.02);
  const auto isPair = [](const auto& match) {
    return (match[0] - Vector3d(10, 8, 10)).norm() < 1e-6 &&
           (match[1] - Vector3d(-5, 6, 22)).norm() < 1e-6;
  };
  EXPECT_TRUE(std::any_of(blend.fill.matches.begin(), blend.fill.matches.end(), isPair));
}

TEST(BlendCorners, RefuseWhatCannotBeMatched) {
  const TopoDS_Shape shape = twoFrames();
  const auto low = [&](double x, double y) { return vertexNear(shape, {x, y, 10}); };
  const auto high = [&](double x, double y) { return vertexNear(shape, {x, y, 22}); };
  BlendPicks picks = framePicks();
  picks.pairs = {
      {low(10, 8), high(5, 6)}, {low(-10, 8), high(-5, -6)}, {low(-10, -8), high(-5, 6)}};
  EXPECT_EQ(refusal(shape, picks), ErrorCode::PairsCross);
  picks.pairs = {{low(10, 8), high(5, 6)}, {low(10, 8), high(-5, 6)}};
  EXPECT_EQ(refusal(shape, picks), ErrorCode::PairsCross);
  picks.pairs = {{low(10, 8), vertexNear(shape, {10, 8, 0})}};
  EXPECT_EQ(refusal(shape, picks), ErrorCode::PairOffChain);
  picks.pairs = {{low(10, 8), 999}};
  EXPECT_EQ(refusal(shape, picks), ErrorCode::VertexOutOfRange);
  picks.pairs = {{low(10, 8), high(5, 6)}};
  picks.alignment = 0.1;
  EXPECT_EQ(refusal(shape, picks), ErrorCode::AlignmentUnused);
  picks.pairs.clear();
  picks.alignment = 0.7;
  EXPECT_EQ(refusal(shape, picks), ErrorCode::AlignmentOutOfRange);
}

// The base of a blend that is set back has numbers of its own.
TEST(BlendCorners, NotesOfASetBackBlendSpeakOfTheEdgesPicked) {
  BlendPicks picks = framePicks();
  picks.setback = {2.0, 1.0};
  const ShapeFill blend = sewn(twoFrames(), picks);
  std::vector<int> picked = picks.from;
  picked.insert(picked.end(), picks.to.begin(), picks.to.end());
  std::vector<int> told;
  for (const analysis::Note& note : blend.fill.report.notes)
    if (note.code == analysis::NoteCode::StripCreased) told.push_back(note.edge);
  EXPECT_THAT(told, ::testing::UnorderedElementsAreArray(picked));
}

}  // namespace
}  // namespace fairing::occt
