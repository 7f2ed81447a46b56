// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/energy/guidance.h"
#include "core/energy/normal_feet.h"

namespace fairing::energy {

/// What a sample is from: a spline or a grid; handles and curves; a reference; a function of the
/// parameters.
enum class GuideKind { Field, Normals, Reference, Parametric };

/// A guidance sample at a patch parameter, with its quadrature weight.
struct WeightedSample {
  double u = 0.0, v = 0.0;
  double weight = 0.0;
  GuidanceSample guide;
  GuideKind kind = GuideKind::Field;
};

/// All samples that guide one patch on knots u x v:
/// - continuous form: Gauss-Legendre with enough points to be exact for polynomial N and S, N not
/// of unit length;
/// - discrete form: the grid's samples, each weighing its share 1/((n+1)(m+1)) of the domain's
/// area;
/// - handles, curves and reference: Gauss-Legendre on the patch's spans, the guide looked up near
/// the patch's `current` shape, `feet` being those of the guide on all current patches.
/// Global lambda and gamma are multiplied in. Places that handles and references say nothing of are
/// there, too, with weight 0. References are asked from several threads.
[[nodiscard]] std::vector<WeightedSample> guidanceSamples(const Guidance& guidance,
                                                          const NormalFeet& feet,
                                                          const spline::KnotVector& u,
                                                          const spline::KnotVector& v,
                                                          const spline::BsplineSurface& current);

}  // namespace fairing::energy
