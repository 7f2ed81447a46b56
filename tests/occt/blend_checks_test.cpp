// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Geom_CylindricalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "occt/blend_shape.h"
#include "occt/from_occt.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using analysis::Note;
using analysis::NoteCode;
using Eigen::Vector3d;

constexpr double kRound = 2.0 * std::numbers::pi;

/// A pipe and the middle of the rim it starts with, which is the nearest to `base`.
struct Pipe {
  TopoDS_Shape shape;
  Vector3d rim;
};

Pipe pipe(double radius, const Vector3d& base, const Vector3d& axis, double length) {
  const gp_Ax3 frame(toPoint(base), gp_Dir(axis.x(), axis.y(), axis.z()));
  const Handle(Geom_CylindricalSurface) surface = new Geom_CylindricalSurface(frame, radius);
  return {grid(surface, {0.0, kRound}, {0.0, length}, {}, Joint::Loose),
          fromOcct(surface->Value(0.5 * kRound, 0.0))};
}

ShapeFill blended(const Pipe& a, const Pipe& b, double alignment = 0.0) {
  const TopoDS_Shape shape = compound({a.shape, b.shape});
  const ShapeIndex index(shape);
  const auto edges = edgesNear(index, {a.rim, b.rim});
  BlendPicks picks{.from = {edges[0]}, .to = {edges[1]}};
  picks.alignment = alignment;
  const auto blend = blendShape(index, picks, {}, ResultMode::Patches);
  EXPECT_TRUE(blend.has_value()) << (blend ? 0 : int(blend.error().code));
  return blend ? ShapeFill(*blend) : ShapeFill{};
}

std::vector<Note> notes(const ShapeFill& blend, NoteCode code) {
  std::vector<Note> found;
  for (const Note& note : blend.fill.report.notes)
    if (note.code == code) found.push_back(note);
  return found;
}

const Vector3d kUp(0, 0, 1);

TEST(BlendChecks, FindNothingWrongWithAGoodBlend) {
  const ShapeFill blend = blended(pipe(5, {0, 0, -8}, -kUp, 6), pipe(9, {3, 1, 8}, {0.3, 0, 1}, 6));
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  EXPECT_TRUE(blend.fill.report.notes.empty());
}

TEST(BlendChecks, AlignmentMovesTheStartAndKeepsTheContacts) {
  const Pipe low = pipe(5, {0, 0, -8}, -kUp, 6), high = pipe(9, {3, 1, 8}, {0.3, 0, 1}, 6);
  const ShapeFill plain = blended(low, high), turned = blended(low, high, 0.1);
  ASSERT_EQ(plain.fill.matches.size(), 1U);
  ASSERT_EQ(turned.fill.matches.size(), 1U);
  EXPECT_TRUE(turned.fill.report.withinTolerance);
  EXPECT_LT(turned.fill.report.largestAngle, 0.02);
  const auto [from, to] = plain.fill.matches.front();
  const auto [fromTurned, toTurned] = turned.fill.matches.front();
  EXPECT_LT((from - fromTurned).norm(), 1e-6);
  // A tenth of the rim: the chord over 36 degrees.
  EXPECT_NEAR((to - toTurned).norm(), 2.0 * 9.0 * std::sin(0.05 * kRound), 1e-6);
}

TEST(BlendChecks, TellsWhereAStripFolds) {
  const ShapeFill blend = blended(pipe(5, {0, 0, 0}, -kUp, 6), pipe(5, {0, 0, 3}, {1, 0, 0.1}, 6));
  const auto folds = notes(blend, NoteCode::StripFolds);
  ASSERT_EQ(folds.size(), 1U);
  EXPECT_GT(folds[0].value, 0.0);
  EXPECT_LT(folds[0].value, 0.5);
  EXPECT_FALSE(blend.fill.patches.empty());
}

TEST(BlendChecks, TellsWhereAStripCutsThroughItself) {
  // Half a turn against each other: every way across passes the axis.
  const ShapeFill blend = blended(pipe(5, {0, 0, -8}, -kUp, 6), pipe(9, {0, 0, 8}, kUp, 6), 0.5);
  EXPECT_FALSE(notes(blend, NoteCode::CutsItself).empty() &&
               notes(blend, NoteCode::StripFolds).empty());
}

TEST(BlendChecks, TellsOfBasesThatOverlap) {
  const ShapeFill blend =
      blended(pipe(5, {0, 0, 0}, -kUp, 20), pipe(4, {12, 0, -8}, {-1, 0, 0}, 24));
  const auto overlaps = notes(blend, NoteCode::BasesOverlap);
  ASSERT_EQ(overlaps.size(), 1U);
  // Where the pipes meet: on both of them.
  EXPECT_NEAR(overlaps[0].where.head<2>().norm(), 5.0, 0.1);
  EXPECT_NEAR(std::hypot(overlaps[0].where.y(), overlaps[0].where.z() + 8.0), 4.0, 0.1);
}

TEST(BlendChecks, TellsOfAFaceTheBlendCuts) {
  // The way from rim to rim leads through the wall of the wide pipe.
  const ShapeFill blend = blended(pipe(2, {3, 0, 0}, {1, 0, 0}, 3), pipe(6, {-4, 0, 5}, -kUp, 20));
  EXPECT_FALSE(notes(blend, NoteCode::CutsFace).empty());
}

}  // namespace
}  // namespace fairing::occt
