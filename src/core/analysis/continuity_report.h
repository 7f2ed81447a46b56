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
  Eigen::Vector3d where = Eigen::Vector3d::Zero();  ///< point of the boundary curve, mm
  double parameter = 0.0;                           ///< of the side, 0 to 1
};

/// One side measured. "Inside" leaves out the 2 % of the length next to either corner, "corner" is these.
struct SideReport {
  int edge = 0;
  int face = 0;
  Continuity asked = Continuity::G1;
  Deviation gap;             ///< boundary curve to the patch's surface, mm
  Deviation angle;           ///< between the normals, inside, degrees
  Deviation cornerAngle;     ///< the same next to the corners, degrees
  Deviation curvature;       ///< relative difference of the normal curvatures across the side, inside, 0 to 1
  double supportDeviation = 0.0;  ///< edge to its own support face as found in the base, mm
  bool backwards = false;    ///< the patch leaves the side on the wrong half of the tangent plane (a cusp)
  bool withinTolerance = false;
  /// Angle along the side for a plot: parameter and degrees, ascending. Empty without a support face.
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

/// Figures of the surface itself (maths.md section 6).
struct FairnessReport {
  double area = 0.0;                 ///< mm^2
  double totalCurvature = 0.0;       ///< integral of k1^2 + k2^2, no unit
  double meanCurvatureGradient = 0.0;///< integral of |grad H|^2, 1/mm^2
  double largestCurvature = 0.0;     ///< 1/mm
};

struct FillReport {
  std::vector<SideReport> sides;
  std::vector<CornerReport> corners;
  FairnessReport fairness;
  double diagonal = 0.0;      ///< of the loop, mm
  double gapLimit = 0.0;      ///< the limits the verdict was made with, mm and degrees
  double angleLimit = 0.0;
  double cornerAngleLimit = 0.0;
  double largestGap = 0.0;    ///< over all sides
  double largestAngle = 0.0;  ///< over all sides with G1, inside
  double largestCornerAngle = 0.0;
  bool withinTolerance = false;
};

/// Measures patches against the loop they were made for, on points of its own (not the solver's).
[[nodiscard]] FillReport measureFill(const boundary::BoundaryLoop& loop, const std::vector<spline::BsplineSurface>& patches,
                                     const Tolerance& tolerance);

}  // namespace fairing::analysis
