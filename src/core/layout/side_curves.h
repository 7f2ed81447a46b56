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

struct SideCurve {
  spline::BsplineCurve curve;  ///< on the knots asked for, in the patch's direction
  double deviation = 0.0;      ///< from the side, mm; 0 where exact
};

/// The side on given knots over [0, 1]; knots that chooseKnots() gave, or finer.
[[nodiscard]] SideCurve curveOnKnots(const DirectedSide& side, const spline::KnotVector& knots);

}  // namespace fairing::layout
