// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/error_text.h"

#include "text/blend_error_text.h"
#include "text/error_parts.h"

namespace fairing::text {
namespace {

std::string ofEdge(const Error& e) {
  return e.edge > 0 ? fmt::format(" of edge {}", e.edge) : "";
}

std::string optionSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::ToleranceNotPositive:
      return fmt::format("The tolerance must be a length above zero, not {}.", number(e.value));
    case ErrorCode::AngleNotPositive:
      return fmt::format("The angle tolerance must be above zero, not {}.", number(e.value));
    case ErrorCode::WeightNegative:
      return fmt::format("The weight {} must be zero or more, not {}.", e.detail, number(e.value));
    case ErrorCode::DegreeTooLow:
      return fmt::format(
          "The energy asked for has third derivatives and needs degree 3 or more, not {}.",
          count(e));
    case ErrorCode::DegreeOutOfRange:
      return fmt::format("The degree must be from 3 to 9, or 0 to have it chosen, not {}.",
                         count(e));
    case ErrorCode::QuadratureOutOfRange:
      return fmt::format(
          "The quadrature must have from 2 to 32 points a span, or 0 to have them chosen, not {}.",
          count(e));
    case ErrorCode::ControlPointLimit:
      return fmt::format("The largest number of control points, {}, leaves no room for a patch.",
                         count(e));
    case ErrorCode::SpansOutOfRange:
      return fmt::format("The number of spans must be from 1 to 64, or 0 to leave it, not {}.",
                         count(e));
    default:
      return fmt::format("There is no choice called {}.", e.detail);
  }
}

std::string guidanceSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::NormalZero:
      if (e.detail == "curve")
        return fmt::format("A normal of curve {} that guides is zero: give it a direction.",
                           count(e));
      return fmt::format("Normal {} of the {} that guide{} is zero: give it a direction.",
                         count(e),
                         e.detail == "handle" ? "handles" : e.detail,
                         e.detail == "handle" ? "" : "s");
    case ErrorCode::CurveNormals:
      return fmt::format(
          "Curve {} that guides has normals for {} points: give one for each, or one for all.",
          count(e),
          e.detail);
    case ErrorCode::FieldSize:
      return fmt::format(
          "A field of {} divisions needs a normal and a weight for every point of its grid, "
          "(n + 1) times (m + 1), and not {}.",
          e.detail,
          count(e));
    case ErrorCode::FieldManyPatches:
      return fmt::format(
          "A field of normals lies on one patch, and here are {}: give handles or a reference, or "
          "ask for the quad layout.",
          count(e));
    case ErrorCode::FieldUnplaced:
      return "A field of normals for a hole must say where it lies: give its \"corners\", the "
             "points of its parameters (0, 0), (1, 0) and (0, 1).";
    case ErrorCode::HandleOff:
      return fmt::format("{}{} guides nothing: the surface is {} beside it, beyond its radius.",
                         e.detail,
                         at(e),
                         length(e.value));
    case ErrorCode::ReferenceOff:
      return "The reference covers nothing of the surface it is to guide: choose faces above or "
             "below it.";
    case ErrorCode::GuideCurveBroken:
      return "The edges of a feature curve do not make one curve: pick edges that go on from one "
             "another.";
    case ErrorCode::GuideCurveBare:
      return "A feature curve has no normals: pick faces beside it, or give a direction.";
    case ErrorCode::GuideCurveAlong:
      return fmt::format(
          "The direction of a feature curve runs along the curve{}: give one across it.", at(e));
    case ErrorCode::MeshInvalid:
      return "The mesh that is to guide has no triangles, or some whose corners are not there: "
             "give "
             "a whole mesh.";
    case ErrorCode::MeshFlipped:
      return fmt::format(
          "The mesh that is to guide is not turned one way: at {} edges, first{}, neighbouring "
          "triangles face opposite sides. Harmonise its normals.",
          count(e),
          at(e));
    default:
      return fmt::format(
          "To keep {} at the border{} all control points have to stay: ask for a higher degree or "
          "more spans, or keep less.",
          e.detail,
          e.face > 0 ? fmt::format(" of face {}", e.face) : "");
  }
}

std::string pickSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::NothingPicked:
      return "No edge is picked, and the shape has no hole to fill.";
    case ErrorCode::EdgeOutOfRange:
      return fmt::format(
          "There is no edge {}: the shape's edges are numbered 1 to {}.", e.edge, count(e));
    case ErrorCode::FaceOutOfRange:
      return fmt::format(
          "There is no face {}: the shape's faces are numbered 1 to {}.", e.face, count(e));
    case ErrorCode::EdgePickedTwice:
      return edge(e) + " is picked twice.";
    case ErrorCode::NoHole:
      return "The shape has no hole to fill: its only free edges are its outer border.";
    case ErrorCode::EdgeNotInLoop:
      return edge(e) + " is given a wish of its own but does not border the hole.";
    case ErrorCode::DirectionAlongEdge:
      return fmt::format(
          "The direction given for edge {} runs along the edge{}: it spans no tangent plane with "
          "it.",
          e.edge,
          at(e));
    case ErrorCode::EdgeOffPlane:
      return fmt::format(
          "{} leaves the symmetry plane given for it by {}{}.", edge(e), length(e.value), at(e));
    case ErrorCode::VertexOutOfRange:
      return fmt::format(
          "There is no vertex {}: the shape's vertices are numbered 1 to {}.", e.edge, count(e));
    case ErrorCode::EdgeNotFree:
      return fmt::format(
          "{} has {} faces beside it, so no surface can go on from it: pick a free edge, or the "
          "face "
          "that is to be replaced.",
          edge(e),
          count(e));
    case ErrorCode::EdgeWithManyFaces:
      return fmt::format(
          "{} has {} faces beside it; at most two can meet in a border.", edge(e), count(e));
    case ErrorCode::EdgeDegenerate:
      return fmt::format(
          "{}{} is no more than a point ({} long).", edge(e), at(e), length(e.value));
    case ErrorCode::EdgeInfinite:
      return edge(e) + " is infinitely long.";
    case ErrorCode::EdgeWithoutFace:
      return edge(e) + " has no face beside it, so it can only be met in position (G0).";
    default:
      return fmt::format(
          "The face beside edge {} has no normal{}: meet this edge in position only (G0).",
          e.edge,
          at(e));
  }
}

std::string loopSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::SeveralLoops:
      return fmt::format(
          "The picked edges belong to {} separate loops; edge {} is not on the first one.",
          count(e),
          e.edge);
    case ErrorCode::LoopNotClosed:
      return e.value > 0.0
                 ? fmt::format("The loop does not close: a gap of {} at the end of edge {}{}.",
                               length(e.value),
                               e.edge,
                               at(e))
                 : fmt::format(
                       "The loop does not close: nothing follows edge {}{}.", e.edge, at(e));
    case ErrorCode::LoopSelfTouching:
      return fmt::format("The loop touches itself at edge {}{}.", e.edge, at(e));
    case ErrorCode::LoopBranches:
      return fmt::format(
          "After edge {}{} several edges could go on: pick more edges of the hole.", e.edge, at(e));
    case ErrorCode::LoopCrossesItself:
      return fmt::format("The loop crosses itself at edge {}{}.", e.edge, at(e));
    case ErrorCode::WrongSideCount:
      return fmt::format("The hole has {} corner{}, which does not suit the chosen layout.",
                         count(e),
                         count(e) == 1 ? "" : "s");
    case ErrorCode::LayoutUnfit:
      return fmt::format("The hole does not suit the {} layout: choose auto.", e.detail);
    case ErrorCode::TooManySides:
      return fmt::format("The hole has {} sides; at most 64 can be spanned.", count(e));
    default:
      return fmt::format("The loop has {} edges, too many to fill.", count(e));
  }
}

std::string netSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::NetTooSmall:
      return fmt::format(
          "A net with {} control points along a direction has none inside its three rings: it "
          "needs "
          "7 or more.",
          count(e));
    case ErrorCode::NetInvalid:
      return fmt::format("The control net cannot be read: {}.", e.detail);
    case ErrorCode::CurveOutside:
      return fmt::format(
          "There is no curve at parameter {}: the patch has {}.", number(e.value), e.detail);
    case ErrorCode::CurvesContradict:
      return fmt::format(
          "The curve {} cannot stay: it misses the given rings or another such curve by {}.",
          e.detail,
          length(e.value));
    default:
      return fmt::format(
          "The start of the patch has no normal{}, so its curvature cannot be improved: start from "
          "another net.",
          at(e));
  }
}

std::string numericSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::CurveNotFitted:
      return fmt::format("{} cannot be followed closely enough: {} remain{}.",
                         e.edge > 0 ? edge(e) : fmt::format("Face {}", e.face),
                         length(e.value),
                         at(e));
    case ErrorCode::InnerConstraintOff:
      return fmt::format("An inner point lies {} from the loop{}, farther than the loop is large.",
                         length(e.value),
                         at(e));
    case ErrorCode::SystemSingular:
      return "The surface is not determined by its edges and options; more continuity or a smaller "
             "weight helps.";
    case ErrorCode::NotFinite:
      return fmt::format("The numbers{} are not finite{}.", ofEdge(e), at(e));
    default:
      return "Cancelled.";
  }
}

std::string fileSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::FileUnreadable:
      return fmt::format("{} cannot be read.", e.detail);
    case ErrorCode::FileNotAShape:
      return fmt::format("{} holds no shape.", e.detail);
    case ErrorCode::FileUnwritable:
      return fmt::format("{} cannot be written.", e.detail);
    case ErrorCode::FileFormatUnknown:
      return fmt::format("{} is neither .brep nor .step by its name.", e.detail);
    case ErrorCode::GuideInvalid:
      return fmt::format("The guide {}.", e.detail);
    case ErrorCode::ShapeEmpty:
      return "The shape has no edges.";
    case ErrorCode::ResultInvalid:
      return fmt::format("The new face is not valid: {}.",
                         e.detail.empty() ? "unknown reason" : e.detail);
    case ErrorCode::SewingOpen:
      return fmt::format("The new faces could not be sewn to {} edge{}, these gaps stay open: {}.",
                         count(e),
                         count(e) == 1 ? "" : "s",
                         e.detail.empty() ? fmt::format("edge {}", e.edge) : e.detail);
    default:
      return fmt::format("The geometry kernel failed: {}.", e.detail);
  }
}

}  // namespace

std::string sentence(const Error& error) {
  if (const auto ofBlend = blendErrorSentence(error)) return *ofBlend;
  switch (error.code) {
    case ErrorCode::ToleranceNotPositive:
    case ErrorCode::AngleNotPositive:
    case ErrorCode::WeightNegative:
    case ErrorCode::DegreeTooLow:
    case ErrorCode::DegreeOutOfRange:
    case ErrorCode::QuadratureOutOfRange:
    case ErrorCode::ControlPointLimit:
    case ErrorCode::UnknownChoice:
    case ErrorCode::SpansOutOfRange:
      return optionSentence(error);
    case ErrorCode::NormalZero:
    case ErrorCode::CurveNormals:
    case ErrorCode::FieldSize:
    case ErrorCode::FieldManyPatches:
    case ErrorCode::FieldUnplaced:
    case ErrorCode::HandleOff:
    case ErrorCode::ReferenceOff:
    case ErrorCode::MeshInvalid:
    case ErrorCode::MeshFlipped:
    case ErrorCode::GuideCurveBroken:
    case ErrorCode::GuideCurveBare:
    case ErrorCode::GuideCurveAlong:
    case ErrorCode::NothingToMove:
      return guidanceSentence(error);
    case ErrorCode::NothingPicked:
    case ErrorCode::EdgeOutOfRange:
    case ErrorCode::FaceOutOfRange:
    case ErrorCode::EdgePickedTwice:
    case ErrorCode::NoHole:
    case ErrorCode::EdgeNotInLoop:
    case ErrorCode::DirectionAlongEdge:
    case ErrorCode::EdgeOffPlane:
    case ErrorCode::VertexOutOfRange:
    case ErrorCode::EdgeNotFree:
    case ErrorCode::EdgeWithManyFaces:
    case ErrorCode::EdgeDegenerate:
    case ErrorCode::EdgeInfinite:
    case ErrorCode::EdgeWithoutFace:
    case ErrorCode::SupportNormalSingular:
      return pickSentence(error);
    case ErrorCode::SeveralLoops:
    case ErrorCode::LoopNotClosed:
    case ErrorCode::LoopSelfTouching:
    case ErrorCode::LoopBranches:
    case ErrorCode::LoopCrossesItself:
    case ErrorCode::WrongSideCount:
    case ErrorCode::LayoutUnfit:
    case ErrorCode::TooManySides:
    case ErrorCode::LoopTooLarge:
      return loopSentence(error);
    case ErrorCode::NetTooSmall:
    case ErrorCode::NetInvalid:
    case ErrorCode::CurveOutside:
    case ErrorCode::CurvesContradict:
    case ErrorCode::NormalVanishes:
      return netSentence(error);
    case ErrorCode::CurveNotFitted:
    case ErrorCode::InnerConstraintOff:
    case ErrorCode::SystemSingular:
    case ErrorCode::NotFinite:
    case ErrorCode::Cancelled:
      return numericSentence(error);
    case ErrorCode::FileUnreadable:
    case ErrorCode::FileNotAShape:
    case ErrorCode::FileUnwritable:
    case ErrorCode::FileFormatUnknown:
    case ErrorCode::GuideInvalid:
    case ErrorCode::ShapeEmpty:
    case ErrorCode::ResultInvalid:
    case ErrorCode::SewingOpen:
    case ErrorCode::Foreign:
      return fileSentence(error);
    default:
      break;
  }
  return "Something went wrong.";
}

}  // namespace fairing::text
