// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/base/result.h"
#include "core/base/tolerance.h"
#include "core/boundary/boundary_loop.h"
#include "core/spline/bspline_surface.h"

namespace fairing::analysis {

/// Largest and root mean square value of a deviation, and where the largest is.
struct Deviation {
  double max = 0.0;
  double rms = 0.0;
  int count = 0;                                    ///< points measured; 0 = not applicable
  Eigen::Vector3d where = Eigen::Vector3d::Zero();  ///< point of the boundary curve, mm
  double parameter = 0.0;                           ///< of the side, 0 to 1
};

/// One side measured. "Inside" leaves out the 2 % of the length next to either corner, "corner" is
/// these.
struct SideReport {
  int edge = 0;
  int face = 0;
  Continuity asked = Continuity::G1;
  Deviation gap;          ///< boundary curve to the patch's surface, mm
  Deviation angle;        ///< between the normals, inside, degrees
  Deviation cornerAngle;  ///< the same next to the corners, degrees
  Deviation
      curvature;  ///< relative difference of the normal curvatures across the side, inside, 0 to 1
  double supportDeviation = 0.0;  ///< edge to its own support face as found in the base, mm
  bool backwards =
      false;  ///< the patch leaves the side on the wrong half of the tangent plane (a cusp)
  bool withinTolerance = false;
  /// Angle along the side for a plot: parameter and degrees, ascending. Empty without a support
  /// face.
  std::vector<std::pair<double, double>> angleCurve;
};

/// What keeps a corner from being met exactly.
struct CornerReport {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  int edgeBefore = 0, edgeAfter = 0;
  double angle = 0.0;           ///< between the sides, degrees
  double normalMismatch = 0.0;  ///< degrees
  double twistMismatch = 0.0;   ///< degrees over a unit of the parameter
  bool normalsAgree = true;     ///< within the angle tolerance
  bool twistsAgree = true;      ///< what the twists leave is within the angle tolerance
};

/// Figures of the surface itself (area and curvature integrals).
struct FairnessReport {
  double area = 0.0;                   ///< mm^2
  double totalCurvature = 0.0;         ///< integral of k1^2 + k2^2, no unit
  double meanCurvatureGradient = 0.0;  ///< integral of |grad H|^2, 1/mm^2
  double largestCurvature = 0.0;       ///< 1/mm
};

struct FillReport {
  std::vector<SideReport> sides;
  std::vector<CornerReport> corners;
  FairnessReport fairness;
  double diagonal = 0.0;  ///< of the loop, mm
  double gapLimit = 0.0;  ///< the limits the verdict was made with, mm and degrees
  double angleLimit = 0.0;
  double cornerAngleLimit = 0.0;
  double largestGap = 0.0;    ///< over all sides
  double largestAngle = 0.0;  ///< over all sides with G1, inside
  double largestCornerAngle = 0.0;
  bool reversed = false;  ///< the patches' normals u x v point against the supports'
  bool withinTolerance = false;
};

/// Where a stretch of a side runs on a patch: the straight line from `start` to `end` in the
/// patch's parameters, affine in the side's parameter over [from, to]. Only a first guess of the
/// feet: the gap is measured to the surface.
struct SideTrace {
  int side = 0;
  int patch = 0;
  double from = 0.0, to = 1.0;
  Eigen::Vector2d start, end;
};

/// Measures patches against the loop they were made for, on points of its own (not the solver's).
[[nodiscard]] FillReport measureFill(const boundary::BoundaryLoop& loop,
                                     const std::vector<spline::BsplineSurface>& patches,
                                     const std::vector<SideTrace>& traces,
                                     const Tolerance& tolerance);

/// The verdict of every side and of the whole from the deviations and the limits in the report. For
/// callers that measure by other means.
void judge(FillReport& report);

/// What is known of a loop before any patch: corners, limits, one empty entry per side.
[[nodiscard]] FillReport emptyReport(const boundary::BoundaryLoop& loop,
                                     const Tolerance& tolerance);

/// One foot of a side point on whatever spans the hole.
struct MeasuredFoot {
  double t = 0.0;  ///< side parameter
  bool inCorner = false;
  Eigen::Vector3d point;   ///< on the side
  double gap = 0.0;        ///< mm
  Eigen::Vector3d normal;  ///< of the patch, unit
  double curvature =
      0.0;  ///< normal curvature of the patch across the side, against `normal`, 1/mm
};

/// Takes one foot into a side's report: gap, and angle and curvature against the support where the
/// side has one. `orientation` is +1 or -1: the sign that turns the patch's normal to the supports'
/// side.
void addFoot(const boundary::BoundarySide& side,
             const MeasuredFoot& foot,
             double diagonal,
             double orientation,
             SideReport& report);
/// Turns the sums kept while feet were added into root mean squares.
void finishSide(SideReport& report);

}  // namespace fairing::analysis
