// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/shape_energy/minimum_variation.h"
#include "core/spline/bspline_surface.h"
#include "core/spline/fundamental_forms.h"

namespace fairing::analysis {

/// Adds up the area and the values of the energies of what fills a hole.
class FairnessSum {
 public:
  /// `diagonal` of the hole, mm.
  explicit FairnessSum(double diagonal);

  /// `weight` of the quadrature point, in the surface's parameters. Points that have no curvature
  /// (where R_u x R_v vanishes) are left out.
  void add(const spline::ThirdOrderJet& jet, double weight);
  [[nodiscard]] const FairnessReport& report() const { return report_; }

 private:
  shape_energy::MinimumVariation variation_;
  FairnessReport report_;
};

/// Of whole patches, by Gauss-Legendre on their spans.
[[nodiscard]] FairnessReport measureFairness(const std::vector<spline::BsplineSurface>& patches,
                                             double diagonal);

}  // namespace fairing::analysis
