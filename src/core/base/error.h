// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

namespace fairing {

/// What went wrong, fine-grained enough that a sentence can be made of it (src/text/error_text.h
/// makes it).
enum class ErrorCode {
  // options
  ToleranceNotPositive,  ///< value = the tolerance given
  AngleNotPositive,      ///< value = the angle given, degrees
  WeightNegative,        ///< detail = "lambda" or "gamma", value = the weight given
  DegreeTooLow,          ///< value = the degree given: the energy has third derivatives
  DegreeOutOfRange,      ///< value = the degree given
  QuadratureOutOfRange,  ///< value = the points a span given
  ControlPointLimit,     ///< value = the limit given
  UnknownChoice,         ///< detail = the option and the word given
  SpansOutOfRange,       ///< value = the number of spans given
  // guidance
  NormalZero,        ///< detail = "handle" or "field", value = number of the normal
  CurveNormals,      ///< value = number of the curve, detail = "2 of 5": its normals and points
  FieldSize,         ///< detail = the grid's divisions, "8 x 8", value = number of normals given
  FieldManyPatches,  ///< value = number of patches: a field lies on one patch only
  FieldUnplaced,     ///< a field for a hole does not say where its corners lie
  HandleOff,         ///< where, detail = "Handle 2" or "Curve 1", value = mm it would have to reach
  ReferenceOff,      ///< the reference covers nothing of the patch
  MeshInvalid,       ///< a mesh without triangles, or with corners that are not there
  MeshFlipped,       ///< where, value = edges whose two triangles are turned against each other
  GuideCurveBroken,  ///< the edges of a feature curve make no single curve
  GuideCurveBare,    ///< a feature curve with neither faces nor a direction
  GuideCurveAlong,   ///< where: its direction runs along the curve
  NothingToMove,     ///< face, detail = "G0", "G1" or "G2": all control points are held
  // picks
  NothingPicked,          ///< no edge given and no loop of free edges found
  EdgeOutOfRange,         ///< edge = number given, value = number of edges in the shape
  FaceOutOfRange,         ///< face = number given, value = number of faces in the shape
  EdgePickedTwice,        ///< edge
  SeveralLoops,           ///< edge = an edge of the second loop, value = number of loops
  LoopNotClosed,          ///< edge = edge at the open end, where = that end, value = gap in mm
  LoopSelfTouching,       ///< edge, where
  LoopBranches,           ///< edge, where: more than two candidate edges meet, pick more edges
  WrongSideCount,         ///< value = number of sides found
  EdgeWithManyFaces,      ///< edge, value = number of faces
  EdgeNotFree,            ///< edge: has two faces; pick the face that is to be replaced
  EdgeDegenerate,         ///< edge, where, value = length in mm
  EdgeInfinite,           ///< edge
  EdgeWithoutFace,        ///< edge: asked for G1 or G2 but has no support face
  SupportNormalSingular,  ///< edge, where
  CurveNotFitted,         ///< edge, where, value = remaining deviation in mm
  LoopTooLarge,           ///< value = number of edges
  EdgeNotInLoop,          ///< edge: something is wished for an edge the hole does not have
  DirectionAlongEdge,     ///< edge, where: the direction given for its tangent plane runs along it
  EdgeOffPlane,           ///< edge, where, value = mm off the symmetry plane given for it
  VertexOutOfRange,       ///< edge = vertex number given, value = number of vertices in the shape
  NoHole,                 ///< the shape has no loop of free edges but outer borders
  LoopCrossesItself,      ///< edge, where
  TooManySides,           ///< value = number of sides
  InnerConstraintOff,     ///< value = distance in mm, where: farther from the loop than it is large
  ChainBroken,            ///< edge: does not connect to the other edges of its side of a blend
  ChainBranches,          ///< edge, where: more than two edges of one side of a blend meet
  ChainTurns,             ///< edge, where, value = degrees: a corner in a loop of a junction
  ChainsUnlike,           ///< edge of the open side: the other side of the blend is closed
  EdgeOnBothSides,        ///< edge: picked for both sides of a blend
  OneSideOnly,            ///< detail = "from" or "to": no edge picked for this side of a blend
  ReachNotPositive,       ///< value = the reach given
  CutUnfit,               ///< edge: shows a cut that joins no neighbours, or joins them again
  CutOffRims,             ///< edge, where, value = mm: a cut's end is not on the junction's sides
  CutsTooClose,           ///< edge, where: two cuts leave it close to each other
  RingWithoutGap,         ///< edge: the chains of a ring touch each other all round
  JunctionWish,           ///< detail = "flip", "setback", ...: not for three loops or more
  ReachVariesRound,       ///< edge of a closed side whose reach is to vary along it
  DepartureNotTangent,    ///< edge met in position only, with a direction or flip asked for
  DepartureAlongEdge,     ///< edge, where: the iso-curves of its face run along it
  SetbackNegative,        ///< value = the setback given
  SetbackWithoutFace,     ///< edge: to be set back, but no face lies beside it
  SetbackTooLarge,        ///< edge, face, value = mm: how far the face lets it go back
  SetbackTwice,           ///< detail = "from" or "to": a distance and a curve for one side
  SetbackCurveBroken,     ///< edge, where: does not go on from the other edges of its curve
  SetbackCurveUnlike,     ///< edge of the curve; detail = "closed" or "open" as the side is, not it
  SetbackCurveOff,        ///< edge of the curve, face, where, value = mm: too far off the face
  SetbackCurveShort,      ///< edge of the curve, face, where, value = mm from its end to the border
  SetbackCurveBeside,     ///< edge, face: the curve does not cut this edge off its face
  CornersDiffer,          ///< edge, value: corners of the first side of a blend, and of the other
  PairOffChain,         ///< edge = vertex number, where: a pair's vertex joins no edges of its side
  PairsCross,           ///< where, detail = "3=7": the pair is out of order with the others
  AlignmentOutOfRange,  ///< value = the alignment given
  AlignmentUnused,      ///< detail = "open" or "paired": why the sides have no start to move
  EndsUnused,           ///< edge of a closed side: it has no ends
  EndOnSide,            ///< edge: picked for an end of a blend, and for a side
  EndJoinsNothing,      ///< edge, where, value = mm off: leads from no end of a side to the other's
  EndTwice,             ///< edge or face, where: a second way for an end that has one
  EndTurns,             ///< edge, where, value = degrees: a corner inside an end
  EndOffFace,           ///< face, where, value = mm: how far off it the nearest end of a blend is
  EndLeavesFace,        ///< face, where, value = mm: a sliding end goes that far beyond its border
  EndAlongSide,         ///< edge of the side, where, value = degrees: no corner of a patch
  EndAgainstSide,       ///< edge of the side, where, value = degrees off the direction asked for
  SetbackPairs,         ///< pairs of vertices asked for together with a setback
  LayoutUnfit,          ///< detail = "quad", "star", ...: the loop does not suit the asked layout
  // nets of control points
  NetTooSmall,       ///< value = control points along the shorter direction
  NetInvalid,        ///< detail = path and what is wrong in it
  CurveOutside,      ///< value = parameter asked for, detail = "u from 3 to 16": the domain
  CurvesContradict,  ///< value = mm, detail = "u = 5": leaves the rings or misses another curve
  NormalVanishes,    ///< where: the start has no normal there, so no curvature
  // numerics
  SystemSingular,  ///< the linear system has no unique solution
  NotFinite,       ///< a NaN or an infinity came in or out; edge if known
  Cancelled,       ///< the caller asked to stop
  // files and shapes
  FileUnreadable,     ///< detail = path
  FileNotAShape,      ///< detail = path
  FileUnwritable,     ///< detail = path
  FileFormatUnknown,  ///< detail = path
  GuideInvalid,       ///< detail = path and what is wrong in it
  ShapeEmpty,         ///< the shape has no edges
  ResultInvalid,      ///< detail = what the check found
  SewingOpen,         ///< edge = first edge left free, value = number of free edges
  Foreign,            ///< detail = message of the CAD kernel
};

/// A failure as a value. Lengths in mm, angles in degrees; `edge` and `face` are FreeCAD's numbers,
/// 0 = not applicable.
struct Error {
  ErrorCode code = ErrorCode::Foreign;
  int edge = 0;
  int face = 0;
  std::optional<Eigen::Vector3d> where = std::nullopt;
  double value = 0.0;
  std::string detail = {};
};

}  // namespace fairing
