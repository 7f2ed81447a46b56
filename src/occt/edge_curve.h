// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <BRepAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <optional>

#include "core/boundary/ribbon.h"

namespace fairing::occt {

/// Which way an edge is run through: with its curve's parameter or against it.
enum class Direction { Forward, Backward };
[[nodiscard]] constexpr Direction opposite(Direction d) {
  return d == Direction::Forward ? Direction::Backward : Direction::Forward;
}

/// The curve of an edge over [0, 1], affine in the edge's own parameter. Not to be shared between
/// threads.
class EdgeCurve {
 public:
  EdgeCurve(const TopoDS_Edge& edge, Direction direction);

  /// Position and derivative with respect to t; NaN where the CAD kernel fails.
  [[nodiscard]] boundary::CurveSample at(double t) const;
  [[nodiscard]] Eigen::Vector3d point(double t) const;
  /// The edge's own parameter at t.
  [[nodiscard]] double parameter(double t) const { return start_ + t * (end_ - start_); }
  [[nodiscard]] bool isFinite() const;

 private:
  BRepAdaptor_Curve curve_;
  double start_ = 0.0, end_ = 1.0;
};

/// The edge as a polynomial B-spline over [0, 1], clamped and at least C1, run through in the given
/// direction; nothing where its curve is no polynomial (arcs, rational, curves on surfaces only) or
/// has a kink. Exact: within 1e-12 of the edge's size.
[[nodiscard]] std::optional<spline::BsplineCurve> polynomialCurve(const TopoDS_Edge& edge,
                                                                  Direction direction);

/// The inner knots of an edge that lies on a B-spline curve, over [0, 1] in the given direction.
[[nodiscard]] std::vector<boundary::CurveBreak> curveBreaks(const TopoDS_Edge& edge,
                                                            Direction direction);

}  // namespace fairing::occt
