// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "core/analysis/loop_probe.h"
#include "core/base/tolerance.h"
#include "core/boundary/boundary_loop.h"

namespace fairing::analysis {

/// Largest and root mean square value of a deviation, and where the largest is.
struct Deviation {
  double max = 0.0;
  double rms = 0.0;
  int count = 0;                                    ///< points measured; 0 = not applicable
  Eigen::Vector3d where = Eigen::Vector3d::Zero();  ///< point of the boundary curve, mm
  double parameter = 0.0;                           ///< of the side, 0 to 1
};

/// Angle between the normals at a side parameter, and the part of it that is the edge's own;
/// degrees.
struct AnglePlace {
  double t = 0.0;
  double angle = 0.0;
  double floor = 0.0;
  bool inCorner = false;
  double curvature = 0.0;  ///< relative mismatch, 0 to 1; 0 in corners
};

/// One side measured. "Inside" leaves out the 2 % of the length next to either corner, "corner" is
/// these.
struct SideReport {
  int edge = 0;
  int face = 0;
  Continuity asked = Continuity::G1;
  boundary::Departure askedDeparture = boundary::Departure::Free;
  boundary::Leaving askedLeaving = boundary::Leaving::Onwards;
  Deviation gap;          ///< boundary curve to the patch's surface, mm
  Deviation angle;        ///< between the normals, inside, degrees
  Deviation cornerAngle;  ///< the same next to the corners, degrees
  /// What cornerAngle may be: the report's cornerAngleLimit, twice that where a corner at either
  /// end has twists that disagree (no smooth patch meets both). Degrees.
  double cornerAngleLimit = 0.0;
  Deviation
      curvature;  ///< relative difference of the normal curvatures across the side, inside, 0 to 1
  /// Between the cross tangents and the direction asked for, degrees; not measured where that is
  /// free.
  Deviation departure;
  double supportDeviation = 0.0;  ///< edge to its own support face as found in the base, mm
  double followedBy =
      0.0;  ///< how far the patch left the edge to follow its face, mm (boundary/follow_support.h)
  bool backwards = false;  ///< the patch leaves the side on the half of the tangent plane that it
                           ///< was not to: in a cusp, unless askedLeaving is Backwards
  bool withinTolerance = false;
  /// The largest angle that is the edge's own: its tangent leaves the support's tangent plane by as
  /// much, and no patch through the edge can come closer there. Degrees.
  double floorAngle = 0.0;
  /// Angle along the side, ascending, for a plot and for refinement. Empty without a support face.
  std::vector<AnglePlace> angleCurve;
};

/// Where two patches of one fill meet.
struct SeamReport {
  int patch = 0, other = 0;
  Deviation gap;        ///< mm
  Deviation angle;      ///< between the normals, degrees
  Deviation curvature;  ///< relative difference of the normal curvatures across the seam, 0 to 1
  bool crease = false;  ///< meant to be met in position only: its angle is no miss
  Continuity asked = Continuity::G1;  ///< where it is no crease: G1 or G2
  /// The same difference over the largest normal curvature across any seam, 0 to 2: it tells what
  /// reflections show, where `curvature` is large beside a flat place. The one that counts for G2.
  Deviation jump = {};
  std::vector<AnglePlace> angleCurve = {};  ///< ascending, over the seam's parameter

  [[nodiscard]] bool asksCurvature() const { return !crease && asked == Continuity::G2; }
};

/// A point or curve the patches were to pass through.
struct InnerReport {
  int number = 0;  ///< of the constraint, from 1 on
  Deviation gap;   ///< distance to the patches, mm
};

/// How well patches follow what guides them (measure_guidance.h).
struct GuidanceReport {
  int normals = 0;            ///< samples with a guiding normal; 0 = angles do not apply
  double rmsAngle = 0.0;      ///< between the normals, whichever way they point; degrees, 0 to 90
  double largestAngle = 0.0;  ///< degrees
  Eigen::Vector3d where = Eigen::Vector3d::Zero();  ///< of the largest angle, on the patch, mm
  int points = 0;            ///< samples with a point of S; 0 = the distance does not apply
  double rmsDistance = 0.0;  ///< to S, mm
  double covered = 1.0;      ///< share of the patches that a reference covers, 0 to 1
};

/// Something the user should know that is no failure.
enum class NoteCode {
  EdgeAbsorbed,      ///< edge, value = length in mm: too short to be a side of its own
  SupportSingular,   ///< edge, where: the support has no normal there; taken from its neighbourhood
  CurvatureUnknown,  ///< edge, where: G2 asked, but the support has no curvature there
  LoopUnfit,         ///< value = degrees: the loop does not suit the trimmed layout's plane
  StripCreased,      ///< edge, where, value = degrees: a blend has a crease from a corner on
  StripFolds,        ///< where, value = share of its area, 0 to 1: a blend is turned over there
  CutsItself,        ///< where, value = extent in mm
  CutsFace,          ///< face, where, value = extent in mm: a blend cuts a face it joins
  BasesOverlap,      ///< where, value = extent in mm: the bases of a blend cut each other
  SetbackOffFace,  ///< edge, face, where, value = mm: a curve to set back to was laid onto the face
  ShapeLimit,      ///< value = steps: the energy of the shape had not come to its minimum
  ShapeStopped,    ///< value = steps: the caller asked for the best shape so far
  ShapeUndefined,  ///< where: the energy of the shape was undefined there; quadratic solution kept
  SetbackExtended,  ///< edge, face, where, value = mm: it was extended to the face's border
  FaceConverted,    ///< face, value = mm: it is no B-spline, and what stands for it is this close
  ReferenceShort,   ///< value = share of the surface that the reference does not cover, 0 to 1
  LookUpsStopped,  ///< value = times: the caller asked for the best there is, the guide still moved
};
struct Note {
  NoteCode code = NoteCode::EdgeAbsorbed;
  int edge = 0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero();
  double value = 0.0;
  int face = 0;
};

/// What keeps a corner from being met exactly.
struct CornerReport {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::size_t sideBefore = 0, sideAfter = 0;  ///< positions in FillReport::sides
  int edgeBefore = 0, edgeAfter = 0;
  double angle = 0.0;           ///< between the sides, degrees
  double normalMismatch = 0.0;  ///< degrees
  double twistMismatch = 0.0;   ///< degrees over a unit of the parameter
  bool normalsAgree = true;     ///< within the angle tolerance
  bool twistsAgree = true;      ///< what the twists leave is within the angle tolerance
};

/// Figures of the surface itself (area and curvature integrals).
struct FairnessReport {
  double area = 0.0;  ///< mm^2
  /// Integral over the parameters of |R_uu|^2 + 2 |R_uv|^2 + |R_vv|^2, mm^2.
  double thinPlate = 0.0;
  double totalCurvature = 0.0;         ///< integral of k1^2 + k2^2, no unit
  double meanCurvatureGradient = 0.0;  ///< integral of |grad H|^2, 1/mm^2
  double minimumVariation = 0.0;       ///< integral of (dk1/de1)^2 + (dk2/de2)^2, 1/mm^2
  double largestCurvature = 0.0;       ///< 1/mm
};

struct FillReport {
  std::vector<SideReport> sides;
  std::vector<CornerReport> corners;
  std::vector<SeamReport> seams;
  std::vector<InnerReport> inner;
  std::vector<Note> notes;
  FairnessReport fairness;
  std::optional<GuidanceReport> guidance;  ///< where anything guides
  double diagonal = 0.0;                   ///< of the loop, mm
  double gapLimit = 0.0;                   ///< the limits the verdict was made with, mm and degrees
  double angleLimit = 0.0;
  double cornerAngleLimit = 0.0;  ///< at corners whose twists agree
  double curvatureLimit = 0.0;    ///< of G2 sides and seams, relative
  double departureLimit = 0.0;    ///< of sides with a direction asked for, degrees
  double largestGap = 0.0;        ///< over all sides
  double largestAngle = 0.0;      ///< over all sides with G1, inside
  double largestCornerAngle = 0.0;
  double largestCurvature = 0.0;  ///< mismatch over all sides with G2, inside, 0 to 1
  double largestSeamGap = 0.0, largestSeamAngle = 0.0;
  double largestSeamJump = 0.0;  ///< of curvature over all seams with G2, 0 to 2
  double largestInnerGap = 0.0;
  bool reversed = false;  ///< the patches' normals u x v point against the supports'
  bool withinTolerance = false;
};

/// What was found where a probe point meets what spans the hole.
struct MeasuredFoot {
  double gap = 0.0;        ///< mm
  Eigen::Vector3d normal;  ///< unit
  double curvature = 0.0;  ///< normal curvature across the side, against `normal`, 1/mm
  /// +1 where the patch lies to the left of the side seen against `normal`, -1 where to the right.
  double side = 1.0;
  /// The derivative across the side, of unit length; zero where what spans the hole has none.
  Eigen::Vector3d across = Eigen::Vector3d::Zero();
};

/// Finds the foot of a probe point of side `side` on whatever spans the hole.
using FootFinder = std::function<MeasuredFoot(std::size_t side, const ProbePoint& probe)>;

/// Measures whatever spans a loop: every deviation, every corner, and the verdict.
[[nodiscard]] FillReport measureLoop(const boundary::BoundaryLoop& loop,
                                     const LoopProbe& probe,
                                     const Tolerance& tolerance,
                                     const FootFinder& footOf);

}  // namespace fairing::analysis
