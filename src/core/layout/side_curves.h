// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/boundary/boundary_loop.h"
#include "core/spline/bspline_curve.h"

namespace fairing::layout {

/// A side, or a stretch of one, seen in a patch's direction: `reversed` where the patch runs
/// against the loop.
struct DirectedSide {
  const boundary::BoundarySide* side = nullptr;
  bool reversed = false;
};

/// Knots on [0, 1] on which all the given sides can be written: polynomial ones exactly (their own
/// knots, degree raised), others within `fitTolerance` mm (spans bisected until they fit, or until
/// `maxPoles` is reached). `degree` 0 chooses: quintic, or the edges' own degree where that would
/// multiply many spans.
[[nodiscard]] spline::KnotVector chooseKnots(const std::vector<DirectedSide>& sides,
                                             int degree,
                                             double fitTolerance,
                                             int maxPoles);

/// Knots on [0, 1] on which all the given sides can be written within `fitTolerance` mm, of degree
/// 5 or more (at least `degree`): a polynomial side with few knots exactly, every other one fitted.
/// For patches that meet in seams.
[[nodiscard]] spline::KnotVector fittingKnots(const std::vector<DirectedSide>& sides,
                                              int degree,
                                              double fitTolerance,
                                              int maxPoles);

/// Given knots, bisected where a side is farther than `tolerance` mm from a fit on them.
[[nodiscard]] spline::KnotVector refinedToFit(const std::vector<DirectedSide>& sides,
                                              const spline::KnotVector& knots,
                                              double tolerance,
                                              int maxPoles);

struct SideCurve {
  spline::BsplineCurve curve;  ///< on the knots asked for, in the patch's direction
  double deviation = 0.0;      ///< from the side, mm; 0 where exact
};

/// The side on given knots over [0, 1]: exactly where it is a polynomial and they hold its knots,
/// else fitted.
[[nodiscard]] SideCurve curveOnKnots(const DirectedSide& side, const spline::KnotVector& knots);

}  // namespace fairing::layout
