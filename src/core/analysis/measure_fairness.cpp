// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/measure_fairness.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/curvature.h"
#include "core/spline/surface_grid.h"

namespace fairing::analysis {
namespace {

// Integrands are rational: four points a span give figures good to about 1e-3, wherever there are
// spans enough.
constexpr int kLeastOnSpan = 4;
constexpr int kLeastOnPatch = 16;

spline::GridLine gridLine(const spline::KnotVector& knots) {
  const int spans = static_cast<int>(knots.breaks().size()) - 1;
  return {knots, std::max(kLeastOnSpan, (kLeastOnPatch + spans - 1) / spans)};
}

}  // namespace

FairnessSum::FairnessSum(double diagonal) : variation_(shape_energy::kUmbilicShare / diagonal) {}

void FairnessSum::add(const spline::ThirdOrderJet& jet, double weight) {
  const Curvature c = curvatureOf(jet);
  if (!std::isfinite(c.mean)) return;  // a collapsed point has no curvature
  const double area = weight * c.areaElement;
  report_.area += area;
  report_.thinPlate += weight * (jet.col(2).squaredNorm() + 2.0 * jet.col(3).squaredNorm() +
                                 jet.col(4).squaredNorm());
  report_.totalCurvature += area * c.total();
  report_.meanCurvatureGradient += area * c.meanGradientSquared;
  report_.minimumVariation += weight * variation_.residuals(jet).squaredNorm();
  report_.largestCurvature = std::max(report_.largestCurvature, c.largest());
}

FairnessReport measureFairness(const std::vector<spline::BsplineSurface>& patches,
                               double diagonal) {
  FairnessSum sum(diagonal);
  for (const spline::BsplineSurface& patch : patches) {
    const spline::GridLine alongU = gridLine(patch.u), alongV = gridLine(patch.v);
    const auto jets = spline::gridJets(patch, alongU, alongV);
    auto jet = jets.begin();
    for (const spline::GridPoint& qu : alongU.points)
      for (const spline::GridPoint& qv : alongV.points) sum.add(*jet++, qu.weight * qv.weight);
  }
  return sum.report();
}

}  // namespace fairing::analysis
