// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <map>
#include <vector>

#include "core/base/tolerance.h"
#include "core/constraint/inner_constraint.h"
#include "core/height_field/height_system.h"
#include "core/height_field/plane_frame.h"

namespace fairing::height_field {

/// What sides and inner constraints ask of a height over a plane, as rows in units of what each may
/// be off by: position always; the slope across the side for G1, of the support's tangent plane;
/// the second derivative across for G2, of the support's normal curvature. All are linear, and the
/// derivatives along the side follow from the position.
class LoopRows {
 public:
  LoopRows(const boundary::BoundaryLoop& loop,
           const std::vector<InnerConstraint>& through,
           const PlaneFrame& frame,
           const Tolerance& tolerance);

  /// Rows dense enough for the cells of the knots: a few on every piece of a side within a cell.
  [[nodiscard]] std::vector<HeightRow> rowsFor(const spline::KnotVector& u,
                                               const spline::KnotVector& v);

 private:
  /// All that is asked at a place, at weight 1.
  using Rows = std::vector<HeightRow>;
  using Curve = std::function<Eigen::Vector3d(double t)>;
  [[nodiscard]] Rows sideRows(std::size_t side, double t) const;
  [[nodiscard]] HeightRow position(const Eigen::Vector3d& point) const;
  template <class At, class RowsAt>
  void sample(const spline::KnotVector& u,
              const spline::KnotVector& v,
              const At& at,
              const RowsAt& rowsAt,
              std::vector<HeightRow>& all) const;

  const boundary::BoundaryLoop& loop_;
  const std::vector<InnerConstraint>& through_;
  PlaneFrame frame_;
  double gapLimit_, angleLimit_, curvatureLimit_;  // in the frame's unit, radians, relative
  std::vector<std::map<double, Rows>> known_;      // a side each: ribbons are dear
};

}  // namespace fairing::height_field
