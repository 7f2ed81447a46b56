// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/error_to_python.h"

#include "python/bindings.h"
#include "text/error_text.h"

namespace py = pybind11;

namespace fairing::python {
namespace {

PyObject* fairingError = nullptr;  // lives as long as the interpreter

/// The enumerator's own name. The compiler warns of a missing one.
const char* name(ErrorCode code) {
  switch (code) {
    case ErrorCode::ToleranceNotPositive:
      return "ToleranceNotPositive";
    case ErrorCode::AngleNotPositive:
      return "AngleNotPositive";
    case ErrorCode::WeightNegative:
      return "WeightNegative";
    case ErrorCode::DegreeTooLow:
      return "DegreeTooLow";
    case ErrorCode::DegreeOutOfRange:
      return "DegreeOutOfRange";
    case ErrorCode::QuadratureOutOfRange:
      return "QuadratureOutOfRange";
    case ErrorCode::ControlPointLimit:
      return "ControlPointLimit";
    case ErrorCode::SpansOutOfRange:
      return "SpansOutOfRange";
    case ErrorCode::NormalZero:
      return "NormalZero";
    case ErrorCode::CurveNormals:
      return "CurveNormals";
    case ErrorCode::FieldSize:
      return "FieldSize";
    case ErrorCode::FieldManyPatches:
      return "FieldManyPatches";
    case ErrorCode::FieldUnplaced:
      return "FieldUnplaced";
    case ErrorCode::HandleOff:
      return "HandleOff";
    case ErrorCode::ReferenceOff:
      return "ReferenceOff";
    case ErrorCode::MeshInvalid:
      return "MeshInvalid";
    case ErrorCode::MeshFlipped:
      return "MeshFlipped";
    case ErrorCode::GuideCurveBroken:
      return "GuideCurveBroken";
    case ErrorCode::GuideCurveBare:
      return "GuideCurveBare";
    case ErrorCode::GuideCurveAlong:
      return "GuideCurveAlong";
    case ErrorCode::NothingToMove:
      return "NothingToMove";
    case ErrorCode::GuideInvalid:
      return "GuideInvalid";
    case ErrorCode::UnknownChoice:
      return "UnknownChoice";
    case ErrorCode::NothingPicked:
      return "NothingPicked";
    case ErrorCode::EdgeOutOfRange:
      return "EdgeOutOfRange";
    case ErrorCode::FaceOutOfRange:
      return "FaceOutOfRange";
    case ErrorCode::EdgePickedTwice:
      return "EdgePickedTwice";
    case ErrorCode::SeveralLoops:
      return "SeveralLoops";
    case ErrorCode::LoopNotClosed:
      return "LoopNotClosed";
    case ErrorCode::LoopSelfTouching:
      return "LoopSelfTouching";
    case ErrorCode::LoopBranches:
      return "LoopBranches";
    case ErrorCode::WrongSideCount:
      return "WrongSideCount";
    case ErrorCode::EdgeWithManyFaces:
      return "EdgeWithManyFaces";
    case ErrorCode::EdgeNotFree:
      return "EdgeNotFree";
    case ErrorCode::EdgeDegenerate:
      return "EdgeDegenerate";
    case ErrorCode::EdgeInfinite:
      return "EdgeInfinite";
    case ErrorCode::EdgeWithoutFace:
      return "EdgeWithoutFace";
    case ErrorCode::SupportNormalSingular:
      return "SupportNormalSingular";
    case ErrorCode::CurveNotFitted:
      return "CurveNotFitted";
    case ErrorCode::NoHole:
      return "NoHole";
    case ErrorCode::LoopCrossesItself:
      return "LoopCrossesItself";
    case ErrorCode::TooManySides:
      return "TooManySides";
    case ErrorCode::InnerConstraintOff:
      return "InnerConstraintOff";
    case ErrorCode::ChainBroken:
      return "ChainBroken";
    case ErrorCode::ChainBranches:
      return "ChainBranches";
    case ErrorCode::ChainTurns:
      return "ChainTurns";
    case ErrorCode::CornersDiffer:
      return "CornersDiffer";
    case ErrorCode::PairOffChain:
      return "PairOffChain";
    case ErrorCode::PairsCross:
      return "PairsCross";
    case ErrorCode::AlignmentOutOfRange:
      return "AlignmentOutOfRange";
    case ErrorCode::AlignmentUnused:
      return "AlignmentUnused";
    case ErrorCode::ChainsUnlike:
      return "ChainsUnlike";
    case ErrorCode::EdgeOnBothSides:
      return "EdgeOnBothSides";
    case ErrorCode::CutUnfit:
      return "CutUnfit";
    case ErrorCode::CutOffRims:
      return "CutOffRims";
    case ErrorCode::CutsTooClose:
      return "CutsTooClose";
    case ErrorCode::RingWithoutGap:
      return "RingWithoutGap";
    case ErrorCode::OneSideOnly:
      return "OneSideOnly";
    case ErrorCode::ReachNotPositive:
      return "ReachNotPositive";
    case ErrorCode::JunctionWish:
      return "JunctionWish";
    case ErrorCode::ReachVariesRound:
      return "ReachVariesRound";
    case ErrorCode::DepartureNotTangent:
      return "DepartureNotTangent";
    case ErrorCode::DepartureAlongEdge:
      return "DepartureAlongEdge";
    case ErrorCode::SetbackNegative:
      return "SetbackNegative";
    case ErrorCode::SetbackWithoutFace:
      return "SetbackWithoutFace";
    case ErrorCode::SetbackTooLarge:
      return "SetbackTooLarge";
    case ErrorCode::EndsUnused:
      return "EndsUnused";
    case ErrorCode::EndOnSide:
      return "EndOnSide";
    case ErrorCode::EndJoinsNothing:
      return "EndJoinsNothing";
    case ErrorCode::EndTwice:
      return "EndTwice";
    case ErrorCode::EndTurns:
      return "EndTurns";
    case ErrorCode::EndOffFace:
      return "EndOffFace";
    case ErrorCode::EndLeavesFace:
      return "EndLeavesFace";
    case ErrorCode::EndAlongSide:
      return "EndAlongSide";
    case ErrorCode::EndAgainstSide:
      return "EndAgainstSide";
    case ErrorCode::SetbackPairs:
      return "SetbackPairs";
    case ErrorCode::SetbackTwice:
      return "SetbackTwice";
    case ErrorCode::SetbackCurveBroken:
      return "SetbackCurveBroken";
    case ErrorCode::SetbackCurveUnlike:
      return "SetbackCurveUnlike";
    case ErrorCode::SetbackCurveOff:
      return "SetbackCurveOff";
    case ErrorCode::SetbackCurveShort:
      return "SetbackCurveShort";
    case ErrorCode::SetbackCurveBeside:
      return "SetbackCurveBeside";
    case ErrorCode::LayoutUnfit:
      return "LayoutUnfit";
    case ErrorCode::NetTooSmall:
      return "NetTooSmall";
    case ErrorCode::NetInvalid:
      return "NetInvalid";
    case ErrorCode::CurveOutside:
      return "CurveOutside";
    case ErrorCode::CurvesContradict:
      return "CurvesContradict";
    case ErrorCode::NormalVanishes:
      return "NormalVanishes";
    case ErrorCode::EdgeNotInLoop:
      return "EdgeNotInLoop";
    case ErrorCode::DirectionAlongEdge:
      return "DirectionAlongEdge";
    case ErrorCode::EdgeOffPlane:
      return "EdgeOffPlane";
    case ErrorCode::VertexOutOfRange:
      return "VertexOutOfRange";
    case ErrorCode::LoopTooLarge:
      return "LoopTooLarge";
    case ErrorCode::SystemSingular:
      return "SystemSingular";
    case ErrorCode::NotFinite:
      return "NotFinite";
    case ErrorCode::Cancelled:
      return "Cancelled";
    case ErrorCode::FileUnreadable:
      return "FileUnreadable";
    case ErrorCode::FileNotAShape:
      return "FileNotAShape";
    case ErrorCode::FileUnwritable:
      return "FileUnwritable";
    case ErrorCode::FileFormatUnknown:
      return "FileFormatUnknown";
    case ErrorCode::ShapeEmpty:
      return "ShapeEmpty";
    case ErrorCode::ResultInvalid:
      return "ResultInvalid";
    case ErrorCode::SewingOpen:
      return "SewingOpen";
    case ErrorCode::Foreign:
      return "Foreign";
  }
  return "";
}

void raise(const Error& error) {
  py::object exception = py::reinterpret_borrow<py::object>(fairingError)(text::sentence(error));
  exception.attr("code") = name(error.code);
  exception.attr("edge") = error.edge;
  exception.attr("face") = error.face;
  exception.attr("value") = error.value;
  exception.attr("where") = py::none();
  if (error.where) {
    exception.attr("where") = py::make_tuple(error.where->x(), error.where->y(), error.where->z());
  }
  PyErr_SetObject(fairingError, exception.ptr());
}

}  // namespace

void bindErrors(py::module_& module) {
  fairingError = PyErr_NewExceptionWithDoc(
      "fairing._fairing.FairingError",
      "What cannot be done, as one sentence; code names the reason, edge and face are FreeCAD's "
      "numbers (0: none), "
      "where is a point in mm or None, value the number the sentence speaks of.",
      PyExc_ValueError,
      nullptr);
  module.attr("FairingError") = py::reinterpret_borrow<py::object>(fairingError);
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const Failure& failure) {
      raise(failure.error());
    }
  });
}

}  // namespace fairing::python
