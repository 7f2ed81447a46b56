// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/report_json.h"

#include "text/note_text.h"
#include "text/report_text.h"
#include "text/words.h"

namespace fairing::text {
namespace {

using nlohmann::json;

json toJson(const Eigen::Vector3d& p) {
  return json::array({p.x(), p.y(), p.z()});
}

json toJson(const analysis::Deviation& d) {
  return {{"max", d.max}, {"rms", d.rms}, {"where", toJson(d.where)}, {"parameter", d.parameter}};
}

json toJson(const analysis::SideReport& side) {
  json curve = json::array();
  for (const auto& place : side.angleCurve) curve.push_back(json::array({place.t, place.angle}));
  return {{"edge", side.edge},
          {"face", side.face},
          {"has_normal", side.angle.count > 0},
          {"asked", word(side.asked)},
          {"gap", toJson(side.gap)},
          {"angle", toJson(side.angle)},
          {"corner_angle", toJson(side.cornerAngle)},
          {"corner_angle_limit", side.cornerAngleLimit},
          {"curvature", toJson(side.curvature)},
          {"asked_departure", word(side.askedDeparture)},
          {"departure", toJson(side.departure)},
          {"flipped", side.askedLeaving == boundary::Leaving::Backwards},
          {"support_deviation", side.supportDeviation},
          {"backwards", side.backwards},
          {"within_tolerance", side.withinTolerance},
          {"followed_by", side.followedBy},
          {"floor_angle", side.floorAngle},
          {"angle_curve", std::move(curve)}};
}

json toJson(const analysis::CornerReport& corner) {
  return {{"point", toJson(corner.point)},
          {"edge_before", corner.edgeBefore},
          {"edge_after", corner.edgeAfter},
          {"angle", corner.angle},
          {"normal_mismatch", corner.normalMismatch},
          {"twist_mismatch", corner.twistMismatch},
          {"normals_agree", corner.normalsAgree},
          {"twists_agree", corner.twistsAgree}};
}

json toJson(const analysis::SeamReport& seam) {
  return {{"patch", seam.patch},
          {"other", seam.other},
          {"gap", toJson(seam.gap)},
          {"angle", toJson(seam.angle)},
          {"curvature", toJson(seam.curvature)},
          {"jump", toJson(seam.jump)},
          {"crease", seam.crease},
          {"asked", word(seam.asked)}};
}

json toJson(const analysis::InnerReport& inner) {
  return {{"number", inner.number}, {"gap", toJson(inner.gap)}};
}

json toJson(const analysis::Note& note) {
  return {{"text", sentence(note)},
          {"edge", note.edge},
          {"face", note.face},
          {"where", toJson(note.where)},
          {"value", note.value}};
}

json toJson(const analysis::FairnessReport& fairness) {
  return {{"area", fairness.area},
          {"thin_plate", fairness.thinPlate},
          {"total_curvature", fairness.totalCurvature},
          {"mean_curvature_gradient", fairness.meanCurvatureGradient},
          {"minimum_variation", fairness.minimumVariation},
          {"largest_curvature", fairness.largestCurvature}};
}

std::string_view word(solver::ShapeEnd end) {
  switch (end) {
    case solver::ShapeEnd::None:
      break;
    case solver::ShapeEnd::Quick:
      return "quick";
    case solver::ShapeEnd::Converged:
      return "converged";
    case solver::ShapeEnd::Stopped:
      return "stopped";
    case solver::ShapeEnd::Limit:
      return "limit";
    case solver::ShapeEnd::Undefined:
      return "undefined";
  }
  return "none";
}

json toJson(const solver::ShapeStep& step) {
  return {{"level", step.level},
          {"energy", step.energy},
          {"anchor", step.anchor},
          {"length", step.length}};
}

template <class T>
json list(const std::vector<T>& items) {
  json result = json::array();
  for (const T& item : items) result.push_back(toJson(item));
  return result;
}

json toJson(const solver::ShapeHistory& shape) {
  return {{"start", shape.start}, {"steps", list(shape.steps)}, {"end", word(shape.end)}};
}

json toJson(const solver::SolveSummary& summary) {
  return {{"solves", summary.solves},
          {"poles", summary.poles},
          {"unknowns", summary.unknowns},
          {"constraints", summary.constraints},
          {"energy", summary.energy},
          {"constraint_residual", summary.constraintResidual},
          {"shape", toJson(summary.shape)},
          {"layout_time", summary.layoutTime},
          {"shape_time", summary.shapeTime},
          {"solve_time", summary.solveTime},
          {"measure_time", summary.measureTime},
          {"total_time", summary.totalTime}};
}

}  // namespace

json notesToJson(const std::vector<analysis::Note>& notes) {
  return list(notes);
}

json toJson(const analysis::GuidanceReport& guidance) {
  return {{"normals", guidance.normals},
          {"rms_angle", guidance.rmsAngle},
          {"largest_angle", guidance.largestAngle},
          {"where", guidance.normals > 0 ? toJson(guidance.where) : json()},
          {"points", guidance.points},
          {"rms_distance", guidance.rmsDistance},
          {"covered", guidance.covered}};
}

json toJson(const analysis::FillReport& report) {
  return {{"within_tolerance", report.withinTolerance},
          {"verdict", verdict(report)},
          {"largest_gap", report.largestGap},
          {"largest_angle", report.largestAngle},
          {"largest_corner_angle", report.largestCornerAngle},
          {"largest_curvature", report.largestCurvature},
          {"largest_seam_gap", report.largestSeamGap},
          {"largest_seam_angle", report.largestSeamAngle},
          {"largest_inner_gap", report.largestInnerGap},
          {"diagonal", report.diagonal},
          {"limits",
           {{"gap", report.gapLimit},
            {"angle", report.angleLimit},
            {"corner_angle", report.cornerAngleLimit},
            {"curvature", report.curvatureLimit}}},
          {"sides", list(report.sides)},
          {"corners", list(report.corners)},
          {"seams", list(report.seams)},
          {"inner", list(report.inner)},
          {"notes", list(report.notes)},
          {"guidance", report.guidance ? toJson(*report.guidance) : json()},
          {"fairness", toJson(report.fairness)}};
}

json toJson(const FillResult& result) {
  json report = toJson(result.report);
  report["layout"] = word(result.layout);
  report["solve"] = toJson(result.summary);
  report["matches"] = json::array();
  for (const auto& [from, to] : result.matches)
    report["matches"].push_back({{"from", toJson(from)}, {"to", toJson(to)}});
  report["patches"] = json::array();
  for (const spline::BsplineSurface& patch : result.patches) {
    report["patches"].push_back({{"degree", {patch.u.degree(), patch.v.degree()}},
                                 {"poles", {patch.u.poleCount(), patch.v.poleCount()}}});
  }
  return report;
}

}  // namespace fairing::text
