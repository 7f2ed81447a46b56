// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/drawn_setback.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Lin.hxx>
#include <numbers>

#include "occt/blends.h"
#include "occt/edge_curve.h"
#include "occt/shapes.h"
#include "text/error_text.h"
#include "text/note_text.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using analysis::Note;
using analysis::NoteCode;
using Eigen::Vector3d;

constexpr int kSamples = 50;

gp_Pnt pnt(const Vector3d& a) {
  return {a.x(), a.y(), a.z()};
}
TopoDS_Edge line(const Vector3d& from, const Vector3d& to) {
  return BRepBuilderAPI_MakeEdge(pnt(from), pnt(to));
}
TopoDS_Edge arc(const Vector3d& from, const Vector3d& through, const Vector3d& to) {
  return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(pnt(from), pnt(through), pnt(to)).Value());
}
/// A B-spline through points; a closed one comes back to the first with its curvature.
TopoDS_Edge spline(const std::vector<Vector3d>& points, bool closed = false) {
  const Handle(TColgp_HArray1OfPnt) through = new TColgp_HArray1OfPnt(1, int(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) through->SetValue(int(k) + 1, pnt(points[k]));
  GeomAPI_Interpolate interpolate(through, closed, 1e-9);
  interpolate.Perform();
  return BRepBuilderAPI_MakeEdge(interpolate.Curve());
}

TopoDS_Shape wall() {
  const Handle(Geom_Surface) plane =
      new Geom_Plane(gp_Ax3(gp_Pnt(12, 0, 9), gp_Dir(-1, 0, 0), gp_Dir(0, -1, 0)));
  return grid(plane, {-20.0, 0.0}, {0.0, 10.0}, {});
}
/// A floor from x = -10 to its edge x = 0 and from y = 0 to 20, of one face or of several side by
/// side, a wall at x = 12 that starts at z = 9, and what is drawn.
TopoDS_Shape floorAndWall(const std::vector<TopoDS_Shape>& drawn,
                          const std::vector<double>& breaks = {0.0, 20.0}) {
  const Handle(Geom_Surface) floor = new Geom_Plane(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
  std::vector<TopoDS_Shape> parts{grid(floor, {-10.0, 0.0}, breaks, {}), wall()};
  parts.insert(parts.end(), drawn.begin(), drawn.end());
  return compound(parts);
}

/// The blend of the floor's edge and the wall's, set back on the floor to the edges drawn there.
struct Case {
  TopoDS_Shape shape;
  BlendPicks picks;
};
std::vector<int> loneEdges(const TopoDS_Shape& shape) {
  const ShapeIndex index(shape);
  std::vector<int> lone;
  for (int edge = 1; edge <= index.edgeCount(); ++edge)
    if (index.uses(edge).empty()) lone.push_back(edge);
  return lone;
}
Case onFloor(const std::vector<TopoDS_Shape>& drawn) {
  const TopoDS_Shape shape = floorAndWall(drawn);
  Case result{shape, between(shape, {0, 10, 0}, {12, 10, 9})};
  result.picks.setbackCurve[0] = loneEdges(shape);
  return result;
}

/// Points of the blend's first side.
std::vector<Vector3d> startOf(const ShapeFill& blend) {
  std::vector<Vector3d> points;
  for (const auto& patch : blend.fill.patches)
    for (int k = 0; k <= kSamples; ++k)
      points.push_back(patch.evaluate(patch.u.last() * k / kSamples, 0.0));
  return points;
}
double distanceTo(const TopoDS_Edge& edge, const Vector3d& point) {
  const EdgeCurve curve(edge, Direction::Forward);
  double t = 0.0, step = 1.0 / 64.0;
  const auto at = [&](double s) { return (curve.point(std::clamp(s, 0.0, 1.0)) - point).norm(); };
  for (int k = 1; k <= 64; ++k)
    if (at(k / 64.0) < at(t)) t = k / 64.0;
  for (; step > 1e-13; step *= 0.5)
    for (bool moved = true; moved;) {
      moved = at(t + step) < at(t) || at(t - step) < at(t);
      if (moved) t += at(t + step) < at(t - step) ? step : -step;
    }
  return at(t);
}
std::vector<Note> notesOf(const ShapeFill& blend, NoteCode code) {
  std::vector<Note> found;
  for (const Note& note : blend.fill.report.notes)
    if (note.code == code) found.push_back(note);
  return found;
}
double areaOfFloor(const TopoDS_Shape& base) {
  double sum = 0.0;
  for (TopExp_Explorer it(base, TopAbs_FACE); it.More(); it.Next()) {
    const ShapeIndex face(it.Current());
    bool isFlat = true;
    for (int edge = 1; edge <= face.edgeCount(); ++edge)
      for (const double t : {0.0, 0.5})
        isFlat =
            isFlat && std::abs(EdgeCurve(face.edge(edge), Direction::Forward).point(t).z()) < 1e-5;
    if (isFlat) sum += area(it.Current());
  }
  return sum;
}

TEST(DrawnSetback, StartsAtALineDrawnOnAPlane) {
  const TopoDS_Edge drawn = line({-3, -1, 0}, {-5, 21, 0});
  const Case c = onFloor({drawn});
  const ShapeFill blend = blended(c.shape, c.picks, ResultMode::Base);
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  EXPECT_LT(blend.fill.report.largestAngle, 1e-3);
  double least = 1e9, most = -1e9;
  for (const Vector3d& p : startOf(blend)) {
    EXPECT_LT(distanceTo(drawn, p), 1e-6);
    least = std::min(least, p.y());
    most = std::max(most, p.y());
  }
  EXPECT_NEAR(least, 0.0, 1e-6);
  EXPECT_NEAR(most, 20.0, 1e-6);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
  EXPECT_NEAR(areaOfFloor(blend.shape), 20.0 * 6.0, 1e-4);  // x = -4 in the middle
  EXPECT_TRUE(notesOf(blend, NoteCode::SetbackOffFace).empty());
  EXPECT_TRUE(notesOf(blend, NoteCode::SetbackExtended).empty());
}

TEST(DrawnSetback, StartsAtArcsAndSplines) {
  const TopoDS_Edge bow = arc({-2, 0, 0}, {-6, 10, 0}, {-2, 20, 0});
  const TopoDS_Edge wave =
      spline({{-3, -1, 0}, {-5, 4, 0}, {-2, 8, 0}, {-4, 12, 0}, {-6, 17, 0}, {-3, 21, 0}});
  for (const TopoDS_Edge& drawn : {bow, wave}) {
    const Case c = onFloor({drawn});
    const ShapeFill blend = blended(c.shape, c.picks, ResultMode::Base);
    EXPECT_TRUE(blend.fill.report.withinTolerance);
    for (const Vector3d& p : startOf(blend)) EXPECT_LT(distanceTo(drawn, p), 1e-5);
    EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
  }
}

TEST(DrawnSetback, TakesPiecesInAnyOrderAndOrientation) {
  const Vector3d low(-3, -1, 0), middle(-4, 8, 0), high(-5, 17, 0), end(-5.5, 21.5, 0);
  const Case whole = onFloor({line(low, end)});
  const std::vector<Vector3d> expected = startOf(blended(whole.shape, whole.picks));
  const TopoDS_Edge a = line(low, middle), b = line(high, middle), c = line(high, end);
  for (const auto& pieces :
       {std::vector<TopoDS_Shape>{a, b, c}, {c, a, b}, {b.Reversed(), c.Reversed(), a}}) {
    Case split = onFloor(pieces);
    std::reverse(split.picks.setbackCurve[0].begin(), split.picks.setbackCurve[0].end());
    const ShapeFill blend = blended(split.shape, split.picks, ResultMode::Base);
    EXPECT_TRUE(blend.fill.report.withinTolerance);
    EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
    const std::vector<Vector3d> start = startOf(blend);
    ASSERT_FALSE(start.empty());
    EXPECT_LT((start.front() - expected.front()).norm(), 1e-6);
    EXPECT_LT((start.back() - expected.back()).norm(), 1e-6);
    for (const Vector3d& p : start) EXPECT_LT(distanceTo(line(low, end), p), 1e-6);
  }
}

TEST(DrawnSetback, LaysACurveAboveTheFaceOntoIt) {
  const Case c = onFloor({line({-3, -1, 0.2}, {-3, 21, 0.4})});
  const ShapeFill blend = blended(c.shape, c.picks, ResultMode::Base);
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  for (const Vector3d& p : startOf(blend)) {
    EXPECT_NEAR(p.x(), -3.0, 1e-6);
    EXPECT_NEAR(p.z(), 0.0, 1e-6);
  }
  const auto notes = notesOf(blend, NoteCode::SetbackOffFace);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].edge, c.picks.setbackCurve[0].front());
  EXPECT_NEAR(notes[0].value, 0.4 - 0.2 / 22.0, 2e-3);  // over the border, as near as places lie
  EXPECT_NEAR(notes[0].where.y(), 20.0, 0.2);
  EXPECT_NE(text::sentence(notes[0]).find("laid onto face"), std::string::npos);
}

TEST(DrawnSetback, ExtendsACurveThatEndsALittleShort) {
  const Case c = onFloor({line({-3, 0.3, 0}, {-4, 20, 0})});
  const ShapeFill blend = blended(c.shape, c.picks, ResultMode::Base);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
  const TopoDS_Edge longer = line({-3 + 0.3 / 19.7, 0, 0}, {-4, 20, 0});
  for (const Vector3d& p : startOf(blend)) EXPECT_LT(distanceTo(longer, p), 1e-6);
  const auto notes = notesOf(blend, NoteCode::SetbackExtended);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NEAR(notes[0].value, std::hypot(0.3, 0.3 / 19.7), 1e-6);
  EXPECT_LT((notes[0].where - Vector3d(-3, 0.3, 0)).norm(), 1e-6);
}

/// Heights of a wavy ring round a pipe of radius 5.
double waveAt(double angle) {
  return -11.0 + 0.8 * std::sin(3.0 * angle);
}
TopoDS_Edge ring(double radius, double start) {
  std::vector<Vector3d> points;
  for (int k = 0; k < 48; ++k) {
    const double angle = start + 2.0 * std::numbers::pi * k / 48;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), waveAt(angle));
  }
  return spline(points, true);
}
Case onPipe(const std::vector<TopoDS_Shape>& drawn) {
  std::vector<TopoDS_Shape> parts{pipe(upright(), 5.0, -14, -8), pipe(upright(), 9.0, 8, 14)};
  parts.insert(parts.end(), drawn.begin(), drawn.end());
  const TopoDS_Shape shape = compound(parts);
  Case result{shape, between(shape, {-5, 0, -8}, {-9, 0, 8})};
  result.picks.setbackCurve[0] = loneEdges(shape);
  return result;
}

// The ring starts at the pipe's seam, or elsewhere.
TEST(DrawnSetback, GoesRoundAPipeAlongAWave) {
  for (const auto& [radius, start] : {std::pair{5.0, 0.0}, {5.2, 1.3}}) {
    const Case c = onPipe({ring(radius, start)});
    const ShapeFill blend = blended(c.shape, c.picks, ResultMode::Base);
    EXPECT_TRUE(blend.fill.report.withinTolerance) << radius;
    EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid()) << radius;
    for (const Vector3d& p : startOf(blend)) {
      EXPECT_NEAR(p.head<2>().norm(), 5.0, 1e-5);
      EXPECT_NEAR(p.z(), waveAt(std::atan2(p.y(), p.x())), 1e-3);
    }
    const auto notes = notesOf(blend, NoteCode::SetbackOffFace);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NEAR(notes[0].value, radius - 5.0, 1e-3);
  }
}

TEST(DrawnSetback, GoesRoundAPipeInPieces) {
  const Vector3d east(5, 0, -11), north(0, 5, -11), west(-5, 0, -11), south(0, -5, -11);
  const Case c = onPipe({arc(west, south, east), arc(west, north, east)});
  const ShapeFill blend = blended(c.shape, c.picks, ResultMode::Base);
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
  for (const Vector3d& p : startOf(blend)) {
    EXPECT_NEAR(p.head<2>().norm(), 5.0, 1e-5);
    EXPECT_NEAR(p.z(), -11.0, 1e-6);
  }
}

/// A surface that ends where its face does, and a line that goes on.
TEST(DrawnSetback, LaysALineOntoAWavedSheet) {
  const Handle(Geom_Surface) waves = wavedSheet();
  double u0, u1, v0, v1;
  waves->Bounds(u0, u1, v0, v1);
  const auto part = [&](double from, double to) {
    return grid(waves, {u0 + from * (u1 - u0), u0 + to * (u1 - u0)}, {v0, v1}, {}, Joint::Loose);
  };
  const TopoDS_Edge drawn = line({9, -2, 1.5}, {8, 32, -1.5});
  const TopoDS_Shape shape = compound({part(0.0, 0.4), part(0.6, 1.0), drawn});
  BlendPicks picks = between(shape, {12, 15, 0}, {18, 15, 0});
  picks.setbackCurve[0] = loneEdges(shape);
  const ShapeFill blend = blended(shape, picks, ResultMode::Base);
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
  const auto notes = notesOf(blend, NoteCode::SetbackOffFace);
  ASSERT_EQ(notes.size(), 1U);
  double farthest = 0.0;
  for (const Vector3d& p : startOf(blend)) {
    const GeomAPI_ProjectPointOnSurf foot(pnt(p), waves);
    EXPECT_LT(foot.LowerDistance(), 1e-5);
    double u = 0.0, v = 0.0;
    foot.LowerDistanceParameters(u, v);
    gp_Pnt on;
    gp_Vec du, dv;
    waves->D1(u, v, on, du, dv);
    const gp_Vec normal = du.Crossed(dv).Normalized();
    // The normal there meets the line.
    const gp_Lin ray(on, gp_Dir(normal)), straight(gp_Pnt(9, -2, 1.5), gp_Dir(-1, 34, -3));
    EXPECT_LT(ray.Distance(straight), 1e-5);
    farthest = std::max(farthest, distanceTo(drawn, p));
  }
  EXPECT_NEAR(notes[0].value, farthest, 0.05);
}

TEST(DrawnSetback, CrossesTheFacesBesideASide) {
  const TopoDS_Edge drawn = arc({-2, -1, 0}, {-5, 9, 0}, {-3, 21, 0});
  const TopoDS_Shape shape = floorAndWall({drawn}, {0.0, 8.0, 20.0});
  BlendPicks picks = between(shape, {0, 4, 0}, {12, 10, 9});
  picks.setbackCurve[0] = loneEdges(shape);
  const ShapeFill blend = blended(shape, picks, ResultMode::Base);
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  EXPECT_TRUE(BRepCheck_Analyzer(blend.shape).IsValid());
  for (const Vector3d& p : startOf(blend)) EXPECT_LT(distanceTo(drawn, p), 1e-5);
  const auto both = edgesNear(ShapeIndex(shape), {{0, 4, 0}, {0, 14, 0}});
  std::vector<int> told;
  for (const auto& side : blend.fill.report.sides) told.push_back(side.edge);
  for (const int edge : both) EXPECT_EQ(std::count(told.begin(), told.end(), edge), 1);
}

TEST(DrawnSetback, GoesWithADistanceOnTheOtherSide) {
  Case c = onFloor({line({-3, -1, 0}, {-3, 21, 0})});
  c.picks.setback = {0.0, 2.0};
  const ShapeFill blend = blended(c.shape, c.picks, ResultMode::Base);
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  const auto& patch = blend.fill.patches.front();
  for (int k = 0; k <= kSamples; ++k) {
    const double u = patch.u.last() * k / kSamples;
    EXPECT_NEAR(patch.evaluate(u, 0.0).x(), -3.0, 1e-6);
    EXPECT_NEAR(patch.evaluate(u, patch.v.last()).z(), 11.0, 1e-6);
  }
  EXPECT_EQ(blend.fill.report.sides[0].edge, c.picks.from.front());
  EXPECT_EQ(blend.fill.report.sides[1].edge, c.picks.to.front());
}

// The face between goes as a whole.
TEST(DrawnSetback, TakesAnEdgeBetweenFaces) {
  const Handle(Geom_Surface) floor = new Geom_Plane(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
  const TopoDS_Shape shape = compound({grid(floor, {-10.0, -3.0, 0.0}, {0.0, 20.0}, {}), wall()});
  BlendPicks picks = between(shape, {0, 10, 0}, {12, 10, 9});
  picks.setbackCurve[0] = edgesNear(ShapeIndex(shape), {{-3, 10, 0}});
  const ShapeFill blend = blended(shape, picks);
  EXPECT_TRUE(blend.fill.report.withinTolerance);
  for (const Vector3d& p : startOf(blend)) EXPECT_NEAR(p.x(), -3.0, 1e-6);
  EXPECT_EQ(blend.fill.report.sides[0].edge, picks.from.front());
}

Error errorOf(const Case& c) {
  return fairing::testing::errorOf(c.shape, c.picks);
}

TEST(DrawnSetback, RefusesACurveTooFarOffItsFace) {
  const Case above = onFloor({line({-3, -1, 0.0}, {-3, 21, 4.0})});
  const Error far = errorOf(above);
  EXPECT_EQ(far.code, ErrorCode::SetbackCurveOff);
  EXPECT_EQ(far.edge, above.picks.setbackCurve[0].front());
  EXPECT_EQ(far.face, 1);
  EXPECT_NEAR(far.value, 4.0 * 21.0 / 22.0, 0.05);
  EXPECT_NEAR(far.where.value().y(), 20.0, 0.2);

  Case wrong = onFloor({line({12, -1, 12}, {12, 21, 12})});  // on the wall, asked of the floor
  const Error other = errorOf(wrong);
  EXPECT_EQ(other.code, ErrorCode::SetbackCurveOff);
  EXPECT_NEAR(other.value, std::hypot(12.0, 12.0), 0.1);
  std::swap(wrong.picks.setbackCurve[0], wrong.picks.setbackCurve[1]);
  EXPECT_TRUE(tryBlend(wrong.shape, wrong.picks).has_value());
}

TEST(DrawnSetback, RefusesACurveThatEndsInsideTheFace) {
  const Case c = onFloor({line({-3, 5, 0}, {-3, 21, 0})});
  const Error error = errorOf(c);
  EXPECT_EQ(error.code, ErrorCode::SetbackCurveShort);
  EXPECT_EQ(error.edge, c.picks.setbackCurve[0].front());
  EXPECT_NEAR(error.value, 5.0, 1e-6);
  EXPECT_LT((error.where.value() - Vector3d(-3, 5, 0)).norm(), 1e-6);
}

TEST(DrawnSetback, RefusesEdgesThatMakeNoSingleChain) {
  const Case apart = onFloor({line({-3, -1, 0}, {-3, 8, 0}), line({-3, 9, 0}, {-3, 21, 0})});
  const Error broken = errorOf(apart);
  EXPECT_EQ(broken.code, ErrorCode::SetbackCurveBroken);
  EXPECT_EQ(broken.edge, apart.picks.setbackCurve[0].back());
  EXPECT_LT((broken.where.value() - Vector3d(-3, 9, 0)).norm(), 1e-9);
  const Vector3d middle(-3, 10, 0);
  const Case fork =
      onFloor({line({-3, -1, 0}, middle), line(middle, {-2, 21, 0}), line(middle, {-5, 21, 0})});
  EXPECT_EQ(errorOf(fork).code, ErrorCode::SetbackCurveBroken);
}

TEST(DrawnSetback, RefusesAClosedCurveOnAnOpenSideAndTheOther) {
  std::vector<Vector3d> round;
  for (int k = 0; k < 12; ++k) {
    const double angle = std::numbers::pi * k / 6;
    round.emplace_back(-5 + 3 * std::cos(angle), 10 + 3 * std::sin(angle), 0);
  }
  const Error open = errorOf(onFloor({spline(round, true)}));
  EXPECT_EQ(open.code, ErrorCode::SetbackCurveUnlike);
  EXPECT_EQ(open.detail, "open");
  const Error closed = errorOf(onPipe({arc({5, 0, -11}, {0, 5, -11}, {-5, 0, -11})}));
  EXPECT_EQ(closed.code, ErrorCode::SetbackCurveUnlike);
  EXPECT_EQ(closed.detail, "closed");
}

TEST(DrawnSetback, RefusesACurveThatDoesNotCutTheEdgeOff) {
  const Case across = onFloor({line({-11, 10, 0}, {1, 10, 0})});  // across the edge itself
  const Error error = errorOf(across);
  EXPECT_EQ(error.code, ErrorCode::SetbackCurveBeside);
  EXPECT_EQ(error.edge, across.picks.from.front());
  EXPECT_EQ(error.face, 1);
}

TEST(DrawnSetback, RefusesADistanceAndACurveOnOneSide) {
  Case c = onFloor({line({-3, -1, 0}, {-3, 21, 0})});
  c.picks.setback = {1.0, 0.0};
  const Error error = errorOf(c);
  EXPECT_EQ(error.code, ErrorCode::SetbackTwice);
  EXPECT_EQ(error.detail, "from");
  c.picks.setback = {};
  c.picks.setbackCurve[0] = {99};
  EXPECT_EQ(errorOf(c).code, ErrorCode::EdgeOutOfRange);
}

}  // namespace
}  // namespace fairing::occt
