// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/blend_error_text.h"

#include "text/error_parts.h"

namespace fairing::text {
namespace {

std::string blendSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::OneSideOnly:
      return fmt::format(
          "No edge is picked for the side \"{}\" of the blend: pick one on either side.", e.detail);
    case ErrorCode::EdgeOnBothSides:
      return fmt::format(
          "Edge {} is picked for both sides of the blend: a blend joins two different edges.",
          e.edge);
    case ErrorCode::ChainBroken:
      return fmt::format(
          "Edge {} does not connect to the other edges of its side of the blend{}: pick the "
          "edges between, leave it out, or ask for a ring of sides.",
          e.edge,
          at(e));
    case ErrorCode::ChainBranches:
      return fmt::format(
          "More than two edges of one side of the blend meet{}: leave out edge {} or another of "
          "them.",
          at(e),
          e.edge);
    case ErrorCode::CornersDiffer:
      return fmt::format(
          "One side of the blend has {} corner{}, the other one {}: match them by length, or set "
          "pairs of vertices.",
          e.edge,
          e.edge == 1 ? "" : "s",
          count(e));
    case ErrorCode::PairOffChain:
      return fmt::format(
          "Vertex {}{} joins no edges of the blend's sides: pair a vertex of one side with one of "
          "the other.",
          e.edge,
          at(e));
    case ErrorCode::PairsCross:
      return fmt::format(
          "The pair of vertices {}{} crosses another one: pairs must follow each other in the "
          "same order on both sides of the blend.",
          e.detail,
          at(e));
    case ErrorCode::AlignmentOutOfRange:
      return fmt::format("The alignment must be from -0.5 to 0.5, not {}.", number(e.value));
    case ErrorCode::AlignmentUnused:
      return e.detail == "open"
                 ? "The sides of the blend are open: their ends belong together, and there is "
                   "nothing to align."
                 : "Pairs of vertices say where the sides of the blend start: leave out the "
                   "alignment or the pairs.";
    case ErrorCode::ChainsUnlike:
      return fmt::format(
          "One side of the blend is closed, the side of edge {} is open: pick two closed "
          "sides or two open ones.",
          e.edge);
    case ErrorCode::ReachVariesRound:
      return fmt::format(
          "The reach of the side of edge {} cannot grow from a start to an end, since it is closed "
          "or "
          "one of three and more: give one number for all of it.",
          e.edge);
    default:
      return fmt::format("The reach must be above 0, not {}.", number(e.value));
  }
}

std::string junctionSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::ChainTurns:
      return fmt::format(
          "One side of the junction turns by {} at the end of edge {}{}: only smooth loops make a "
          "junction.",
          angle(e.value),
          e.edge,
          at(e));
    case ErrorCode::CutUnfit:
      return fmt::format(
          "Edge {} is no cut of a junction: one cut at most joins two closed sides that are "
          "neighbours.",
          e.edge);
    case ErrorCode::CutOffRims:
      return fmt::format(
          "The cut of edge {} ends {} off the sides of the junction{}: draw it from one side to "
          "another.",
          e.edge,
          length(e.value),
          at(e));
    case ErrorCode::CutsTooClose:
      return fmt::format(
          "The two cuts that leave the side of edge {} are too close to each other{}: set them "
          "farther apart.",
          e.edge,
          at(e));
    case ErrorCode::RingWithoutGap:
      return fmt::format(
          "The edges picked, edge {} among them, enclose a hole without a gap: fill the hole.",
          e.edge);
    default:
      return fmt::format("A blend of three sides or more takes no {}: leave it out.", e.detail);
  }
}

std::string endSentence(const Error& e) {
  const std::string face = fmt::format("Face {}", e.face);
  switch (e.code) {
    case ErrorCode::EndsUnused:
      return fmt::format(
          "The side of edge {} is closed, so the blend has no ends to follow anything: leave out "
          "the ends.",
          e.edge);
    case ErrorCode::EndOnSide:
      return edge(e) +
             " is picked for an end of the blend, but belongs to one of its sides: leave it out of "
             "one of them.";
    case ErrorCode::EndJoinsNothing:
      return fmt::format(
          "{} leads from no end of one side of the blend to an end of the other: it stops {} from "
          "the nearest one{}; pick edges all the way, or leave it out.",
          edge(e),
          length(e.value),
          at(e));
    case ErrorCode::EndTwice:
      return fmt::format(
          "{} is a second way for the end of the blend{}, which follows another one: leave out one "
          "of the two.",
          e.edge > 0 ? edge(e) : face,
          at(e));
    case ErrorCode::EndTurns:
      return fmt::format(
          "The end of the blend turns by {} after edge {}{}: an end must be smooth; leave it free, "
          "or fill the hole between all edges.",
          angle(e.value),
          e.edge,
          at(e));
    case ErrorCode::EndLeavesFace:
      return fmt::format(
          "The end of the blend would slide {} beyond the border of face {}{}: pick a larger face, "
          "or leave the end free.",
          length(e.value),
          e.face,
          at(e));
    case ErrorCode::EndAlongSide:
      return fmt::format(
          "The end of the blend makes an angle of {} with the side of edge {}{}, no corner for a "
          "patch: leave the end free, or fill the hole between all edges.",
          angle(e.value),
          e.edge,
          at(e));
    case ErrorCode::EndAgainstSide:
      return fmt::format(
          "The end of the blend leaves edge {}{} {} off the direction asked for: leave the "
          "direction "
          "of that side free, or the end.",
          e.edge,
          at(e),
          angle(e.value));
    default:
      return fmt::format(
          "{} has no border from one side of the blend to the other, and the nearest end lies {} "
          "off it{}: pick a face both sides end on.",
          face,
          length(e.value),
          at(e));
  }
}

std::string departureSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::DepartureNotTangent:
      return fmt::format(
          "{} is met in position only (G0), so no direction can be asked for there: ask for G1 or "
          "G2, or leave the direction free.",
          edge(e));
    case ErrorCode::DepartureAlongEdge:
      return fmt::format(
          "The iso-curves of the face beside edge {} run along the edge{}: leave it "
          "perpendicularly, or freely.",
          e.edge,
          at(e));
    case ErrorCode::SetbackNegative:
      return fmt::format("The setback must be a length of zero or more, not {}.", number(e.value));
    case ErrorCode::SetbackWithoutFace:
      return edge(e) + " has no face beside it, so the blend cannot be set back from it.";
    case ErrorCode::SetbackPairs:
      return "A blend that is set back has no vertices of its own to pair: leave out the pairs or "
             "the "
             "setback.";
    default:
      return fmt::format("Edge {} cannot be set back as far: face {} ends after {}{}.",
                         e.edge,
                         e.face,
                         length(e.value),
                         at(e));
  }
}

std::string drawnSentence(const Error& e) {
  switch (e.code) {
    case ErrorCode::SetbackTwice:
      return fmt::format(
          "The side \"{}\" is set back by a distance and by a curve: give one of them.", e.detail);
    case ErrorCode::SetbackCurveBroken:
      return fmt::format(
          "The edges of the curve a side is set back to make no single chain: edge {} does not go "
          "on from the others{}.",
          e.edge,
          at(e));
    case ErrorCode::SetbackCurveUnlike:
      return e.detail == "closed"
                 ? fmt::format(
                       "The side is closed, the curve of edge {} it is set back to is not: draw it "
                       "all round.",
                       e.edge)
                 : fmt::format(
                       "The side is open, the curve of edge {} it is set back to is closed: draw "
                       "it "
                       "from border to border.",
                       e.edge);
    case ErrorCode::SetbackCurveOff:
      return fmt::format(
          "The curve a side is set back to leaves face {} by {}: edge {}{}; draw it on the face or "
          "close to it.",
          e.face,
          length(e.value),
          e.edge,
          at(e));
    case ErrorCode::SetbackCurveShort:
      return fmt::format(
          "The curve a side is set back to ends inside face {}{}{}: draw edge {} as far as the "
          "border.",
          e.face,
          at(e),
          e.value > 0.0 ? fmt::format(", {} from its border", length(e.value)) : "",
          e.edge);
    default:
      return fmt::format(
          "The curve the side is set back to does not cut edge {} off face {}: draw it from border "
          "to border of the face, without touching the edge.",
          e.edge,
          e.face);
  }
}

}  // namespace

std::optional<std::string> blendErrorSentence(const Error& error) {
  switch (error.code) {
    case ErrorCode::OneSideOnly:
    case ErrorCode::EdgeOnBothSides:
    case ErrorCode::ChainBroken:
    case ErrorCode::ChainBranches:
    case ErrorCode::CornersDiffer:
    case ErrorCode::PairOffChain:
    case ErrorCode::PairsCross:
    case ErrorCode::AlignmentOutOfRange:
    case ErrorCode::AlignmentUnused:
    case ErrorCode::ChainsUnlike:
    case ErrorCode::ReachNotPositive:
    case ErrorCode::ReachVariesRound:
      return blendSentence(error);
    case ErrorCode::ChainTurns:
    case ErrorCode::CutUnfit:
    case ErrorCode::CutOffRims:
    case ErrorCode::CutsTooClose:
    case ErrorCode::RingWithoutGap:
    case ErrorCode::JunctionWish:
      return junctionSentence(error);
    case ErrorCode::EndsUnused:
    case ErrorCode::EndOnSide:
    case ErrorCode::EndJoinsNothing:
    case ErrorCode::EndTwice:
    case ErrorCode::EndTurns:
    case ErrorCode::EndOffFace:
    case ErrorCode::EndLeavesFace:
    case ErrorCode::EndAlongSide:
    case ErrorCode::EndAgainstSide:
      return endSentence(error);
    case ErrorCode::DepartureNotTangent:
    case ErrorCode::DepartureAlongEdge:
    case ErrorCode::SetbackNegative:
    case ErrorCode::SetbackWithoutFace:
    case ErrorCode::SetbackTooLarge:
    case ErrorCode::SetbackPairs:
      return departureSentence(error);
    case ErrorCode::SetbackTwice:
    case ErrorCode::SetbackCurveBroken:
    case ErrorCode::SetbackCurveUnlike:
    case ErrorCode::SetbackCurveOff:
    case ErrorCode::SetbackCurveShort:
    case ErrorCode::SetbackCurveBeside:
      return drawnSentence(error);
    default:
      return std::nullopt;
  }
}

}  // namespace fairing::text
