// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/energy/guidance.h"

namespace fairing::energy {

/// A guidance sample at a patch parameter, with its quadrature weight.
struct WeightedSample {
  double u = 0.0, v = 0.0;
  double weight = 0.0;
  GuidanceSample guide;
};

/// All samples that guide one patch on knots u x v:
/// - continuous form: Gauss-Legendre with enough points to be exact for polynomial N and S, N not
/// of unit length;
/// - discrete form: the grid's samples, each weighing its share 1/((n+1)(m+1)) of the domain's
/// area;
/// - handles and reference: Gauss-Legendre on the patch's spans, the guide looked up near the
/// patch's `current` shape. Global lambda and gamma are multiplied in.
[[nodiscard]] std::vector<WeightedSample> guidanceSamples(const Guidance& guidance,
                                                          const spline::KnotVector& u,
                                                          const spline::KnotVector& v,
                                                          const spline::BsplineSurface& current);

}  // namespace fairing::energy
