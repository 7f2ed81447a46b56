// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/report_text.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <set>

#include "text/note_text.h"
#include "text/quantities.h"
#include "text/report_json.h"
#include "text/words.h"

namespace fairing::text {
namespace {

using analysis::FillReport;
using analysis::SideReport;
using ::testing::HasSubstr;
using ::testing::StartsWith;

analysis::Deviation deviation(double max, const Eigen::Vector3d& where = {12.0, 3.1, 0.0}) {
  analysis::Deviation d;
  d.max = max;
  d.rms = 0.5 * max;
  d.count = 10;
  d.where = where;
  return d;
}

/// Four edges well within the limits.
FillReport good() {
  FillReport report;
  report.gapLimit = 1e-5;
  report.angleLimit = 0.02;
  report.cornerAngleLimit = 0.05;
  report.largestGap = 12e-6 * 1e-1;
  report.largestAngle = 0.004;
  report.withinTolerance = true;
  for (int edge : {7, 9, 12, 15}) {
    SideReport side;
    side.edge = edge;
    side.face = edge + 1;
    side.gap = deviation(1.2e-6);
    side.angle = deviation(0.004);
    side.cornerAngle = deviation(0.001);
    side.cornerAngleLimit = report.cornerAngleLimit;
    side.withinTolerance = true;
    report.sides.push_back(side);
  }
  return report;
}

TEST(Verdict, SaysHowWellAllEdgesAreMet) {
  EXPECT_EQ(verdict(good()), "Meets all 4 edges: tangent within 0.004\u00b0, gap 1.2 nm.");
}

TEST(Verdict, NamesEdgesMetInPositionOnly) {
  FillReport report = good();
  report.sides[1].asked = Continuity::G0;
  EXPECT_THAT(verdict(report), StartsWith("Meets all 4 edges (in position only: 9)"));
}

TEST(Verdict, NamesTheWorstEdgeWithSizeAndPlace) {
  FillReport report = good();
  report.withinTolerance = false;
  report.sides[0].angle = deviation(0.31);
  report.sides[0].withinTolerance = false;
  report.sides[2].gap = deviation(2e-5);
  report.sides[2].withinTolerance = false;
  EXPECT_THAT(verdict(report), StartsWith("Edge 7 misses tangency by 0.31\u00b0"));
  EXPECT_THAT(verdict(report), HasSubstr("(12, 3.1, 0)"));
  EXPECT_THAT(verdict(report), HasSubstr("2 of 4 edges are out of tolerance."));
}

TEST(Verdict, GivesTheReasonAtACornerWhoseFacesDisagree) {
  FillReport report = good();
  report.withinTolerance = false;
  report.sides[0].cornerAngle = deviation(0.31);
  report.sides[0].withinTolerance = false;
  analysis::CornerReport corner;
  corner.point = {12.0, 3.1, 0.0};
  corner.edgeBefore = 7;
  corner.edgeAfter = 9;
  corner.normalMismatch = 0.6;
  corner.normalsAgree = false;
  report.corners.push_back(corner);
  EXPECT_THAT(verdict(report), HasSubstr("the faces beside edges 7 and 9 differ by 0.6\u00b0"));
}

TEST(Verdict, TellsACuspBeforeAnythingElse) {
  FillReport report = good();
  report.withinTolerance = false;
  report.sides[3].backwards = true;
  report.sides[3].withinTolerance = false;
  report.sides[0].angle = deviation(5.0);
  EXPECT_THAT(verdict(report), HasSubstr("edge 15 backwards"));
}

TEST(Verdict, SaysHowWellCurvatureSeamsAndInnerConstraintsAreMet) {
  FillReport report = good();
  for (SideReport& side : report.sides) side.asked = Continuity::G2;
  report.largestCurvature = 0.004;
  report.seams.push_back({0, 1, deviation(1e-9), deviation(0.001), deviation(0.02)});
  report.largestSeamAngle = 0.001;
  report.inner.push_back({1, deviation(2e-6)});
  report.largestInnerGap = 2e-6;
  EXPECT_EQ(verdict(report),
            "Meets all 4 edges: tangent within 0.004\u00b0, curvature within 0.4 %, gap 1.2 nm; "
            "seams within 0.001\u00b0; inner constraints within 2 nm.");
}

TEST(Verdict, NamesACurvatureMissOfASideThatAskedForIt) {
  FillReport report = good();
  report.withinTolerance = false;
  report.curvatureLimit = 0.01;
  report.sides[2].curvature = deviation(0.3);
  EXPECT_THAT(verdict(report), ::testing::Not(HasSubstr("curvature")));  // G1 was asked
  report.sides[2].asked = Continuity::G2;
  EXPECT_THAT(verdict(report), StartsWith("Edge 12 misses the curvature beside it by 30 %"));
  EXPECT_THAT(verdict(report), HasSubstr("allowed: 1.0 %"));
}

TEST(Verdict, NamesPatchesWhoseSeamIsMissed) {
  FillReport report = good();
  report.withinTolerance = false;
  report.seams.push_back({1, 2, deviation(1e-9), deviation(0.7), deviation(0.0)});
  EXPECT_THAT(verdict(report), StartsWith("Patches 2 and 3 miss tangency by 0.7\u00b0"));
  report.seams[0].gap = deviation(0.1);
  EXPECT_THAT(verdict(report), StartsWith("Patches 2 and 3 are apart by 0.1 mm"));
}

TEST(Verdict, SpeaksOfCurvatureBetweenPatchesWhereItIsAsked) {
  FillReport report = good();
  report.seams.push_back({0, 1, deviation(1e-9), deviation(0.001), deviation(0.02)});
  report.largestSeamAngle = 0.001;
  report.curvatureLimit = 0.01;
  report.largestSeamJump = 0.004;
  report.seams[0].jump = deviation(0.004);
  EXPECT_THAT(verdict(report), ::testing::Not(HasSubstr("curvature")));
  report.seams[0].asked = Continuity::G2;
  EXPECT_THAT(verdict(report),
              HasSubstr("seams within 0.001\u00b0, curvature jumps within 0.4 %."));
  report.withinTolerance = false;
  report.seams[0].jump = deviation(0.3);
  EXPECT_THAT(verdict(report), StartsWith("Patches 1 and 2 differ in curvature by 30 %"));
}

TEST(Verdict, NamesAnInnerConstraintThatIsMissed) {
  FillReport report = good();
  report.withinTolerance = false;
  report.inner.push_back({3, deviation(0.5)});
  EXPECT_THAT(verdict(report), StartsWith("Inner constraint 3 is missed by 0.5 mm"));
}

TEST(Verdict, SpeaksOfOneEdgeAsOne) {
  FillReport report = good();
  report.sides.resize(1);
  EXPECT_THAT(verdict(report), StartsWith("Meets its edge: tangent"));
}

TEST(Table, HasALineForEveryEdge) {
  const std::string text = table(good());
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
  for (const char* edge : {" 7 ", " 9 ", " 12 ", " 15 "}) EXPECT_THAT(text, HasSubstr(edge));
}

TEST(Table, ListsSeamsInnerConstraintsAndNotes) {
  FillReport report = good();
  report.seams.push_back({0, 1, deviation(1e-9), deviation(0.001), deviation(0.02)});
  report.inner.push_back({1, deviation(2e-6)});
  report.notes.push_back({analysis::NoteCode::EdgeAbsorbed, 9, {0, 0, 0}, 0.02});
  const std::string text = table(report);
  EXPECT_THAT(text, HasSubstr("1 - 2"));
  EXPECT_THAT(text, HasSubstr("2 nm"));
  EXPECT_THAT(text, HasSubstr("Note: Edge 9 is too short (20 \u00b5m)"));
}

TEST(Table, HasALineForEveryHole) {
  FillResult fill;
  fill.report = good();
  fill.layout = LayoutKind::Star;
  const Error error{.code = ErrorCode::LoopSelfTouching, .edge = 31};
  const std::string text = table({{{7, 9, 12, 15}, &fill, nullptr}, {{31, 32}, nullptr, &error}});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_THAT(text, HasSubstr("star"));
  EXPECT_THAT(text, HasSubstr("Meets all 4 edges"));
  EXPECT_THAT(text, HasSubstr("The loop touches itself at edge 31."));
}

TEST(Notes, AreOneSentenceEachOfTheirOwn) {
  std::set<std::string> all;
  using analysis::NoteCode;
  for (const NoteCode code : {NoteCode::EdgeAbsorbed,
                              NoteCode::SupportSingular,
                              NoteCode::CurvatureUnknown,
                              NoteCode::LoopUnfit,
                              NoteCode::StripCreased,
                              NoteCode::StripFolds,
                              NoteCode::CutsItself,
                              NoteCode::CutsFace,
                              NoteCode::BasesOverlap,
                              NoteCode::SetbackOffFace,
                              NoteCode::SetbackExtended,
                              NoteCode::ShapeLimit,
                              NoteCode::ShapeUndefined,
                              NoteCode::ShapeStopped,
                              NoteCode::LookUpsStopped}) {
    const std::string text = sentence(analysis::Note{code, 17, {1.5, -2.0, 0.0}, 3.0});
    EXPECT_THAT(text, ::testing::EndsWith("."));
    EXPECT_TRUE(all.insert(text).second) << text;
  }
}

TEST(ReportJson, HoldsSeamsInnerConstraintsAndNotes) {
  FillReport report = good();
  report.curvatureLimit = 0.01;
  report.seams.push_back({0, 1, deviation(1e-9), deviation(0.001), deviation(0.02)});
  report.inner.push_back({1, deviation(2e-6)});
  report.notes.push_back({analysis::NoteCode::SupportSingular, 9, {1, 2, 3}, 0.0});
  const auto json = nlohmann::json::parse(toJson(report).dump());
  EXPECT_DOUBLE_EQ(json.at("seams")[0].at("angle").at("max").get<double>(), 0.001);
  EXPECT_DOUBLE_EQ(json.at("inner")[0].at("gap").at("max").get<double>(), 2e-6);
  EXPECT_EQ(json.at("notes")[0].at("edge"), 9);
  EXPECT_DOUBLE_EQ(json.at("limits").at("curvature").get<double>(), 0.01);
}

TEST(ReportJson, TellsTheWayToTheShape) {
  FillResult fill;
  solver::ShapeHistory& shape = fill.summary.shape;
  shape.start = 8.0;
  shape.steps = {{0, 2.0, 0.5, 0.1}, {1, 1.0, 0.25, 0.01}};
  shape.end = solver::ShapeEnd::Limit;
  const auto json = nlohmann::json::parse(toJson(fill).dump()).at("solve").at("shape");
  EXPECT_EQ(json.at("end"), "limit");
  EXPECT_DOUBLE_EQ(json.at("start").get<double>(), 8.0);
  ASSERT_EQ(json.at("steps").size(), 2u);
  EXPECT_EQ(json.at("steps")[1].at("level"), 1);
  EXPECT_DOUBLE_EQ(json.at("steps")[1].at("energy").get<double>(), 1.0);
  EXPECT_DOUBLE_EQ(json.at("steps")[1].at("anchor").get<double>(), 0.25);
  EXPECT_DOUBLE_EQ(json.at("steps")[1].at("length").get<double>(), 0.01);
}

TEST(Composition, TellsTheWayToTheMinimumInShort) {
  FillResult fill;
  EXPECT_THAT(composition(fill), ::testing::Not(::testing::HasSubstr("Energy")));
  fill.summary.shape.start = 8.0;
  fill.summary.shape.steps = {{0, 2.0, 0.5, 0.1}, {1, 1.25, 0.25, 0.01}};
  fill.summary.shape.end = solver::ShapeEnd::Stopped;
  EXPECT_THAT(composition(fill),
              ::testing::EndsWith("Energy of the shape 1.25, from 8 in 2 steps."));
  EXPECT_EQ(nlohmann::json::parse(toJson(fill).dump()).at("solve").at("shape").at("end"),
            "stopped");
}

TEST(ReportJson, KeepsTheNumbersAndTurnsNonsenseToNull) {
  FillReport report = good();
  report.fairness.area = std::numeric_limits<double>::quiet_NaN();
  const auto json = nlohmann::json::parse(toJson(report).dump());
  EXPECT_TRUE(json.at("within_tolerance").get<bool>());
  EXPECT_EQ(json.at("sides").size(), 4u);
  EXPECT_EQ(json.at("sides")[0].at("edge"), 7);
  EXPECT_EQ(json.at("sides")[0].at("asked"), "G1");
  EXPECT_DOUBLE_EQ(json.at("sides")[0].at("angle").at("max").get<double>(), 0.004);
  EXPECT_DOUBLE_EQ(json.at("limits").at("gap").get<double>(), 1e-5);
  EXPECT_TRUE(json.at("fairness").at("area").is_null());
}

TEST(Quantities, ChooseUnitsPeopleRead) {
  EXPECT_EQ(length(0.0), "0 mm");
  EXPECT_EQ(length(12e-9), "0.012 nm");
  EXPECT_EQ(length(12e-6), "12 nm");
  EXPECT_EQ(length(0.0031), "3.1 \u00b5m");
  EXPECT_EQ(length(0.27), "0.27 mm");
  EXPECT_EQ(length(1234.5), "1234 mm");
  EXPECT_EQ(angle(0.0), "0\u00b0");
  EXPECT_EQ(angle(0.0042), "0.0042\u00b0");
  EXPECT_EQ(point({1e-17, 3.1, 1234.56}), "(0, 3.1, 1234.6)");
}

TEST(Words, AreUnderstoodAsTheyAreWritten) {
  for (const Continuity c : {Continuity::G0, Continuity::G1, Continuity::G2})
    EXPECT_EQ(continuityFrom(word(c)), c);
  for (const EnergyKind e : {EnergyKind::Membrane,
                             EnergyKind::ThinPlate,
                             EnergyKind::MeanCurvatureGradient,
                             EnergyKind::MeanCurvatureGradientMinimum,
                             EnergyKind::MinimumVariation,
                             EnergyKind::TotalCurvature,
                             EnergyKind::Triharmonic})
    EXPECT_EQ(energyFrom(word(e)), e);
  for (const LayoutKind l : {LayoutKind::Auto,
                             LayoutKind::Quad,
                             LayoutKind::Star,
                             LayoutKind::OGrid,
                             LayoutKind::Trimmed})
    EXPECT_EQ(layoutFrom(word(l)), l);
  EXPECT_FALSE(continuityFrom("g1").has_value());
  for (const auto f : {spline::QuadratureFamily::Gauss, spline::QuadratureFamily::Lobatto})
    EXPECT_EQ(quadratureFrom(word(f)), f);
  EXPECT_FALSE(energyFrom("").has_value());
}

}  // namespace
}  // namespace fairing::text
