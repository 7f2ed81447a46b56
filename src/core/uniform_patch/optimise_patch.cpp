// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/optimise_patch.h"

#include <Eigen/LU>

#include "core/base/stopwatch.h"
#include "core/uniform_patch/triharmonic.h"

namespace fairing::uniform_patch {
namespace {

// A transformation that flattens space more than this has no inverse to speak of.
constexpr double kFlattest = 1e-9;

spline::Poles mapped(const spline::Poles& points, const Eigen::Matrix3d& map) {
  return points * map.transpose();
}

ControlNet mapped(ControlNet net, const Eigen::Matrix3d& map) {
  net.points = mapped(net.points, map);
  return net;
}

// The curves with their control points, so that they stay whatever the inner points become.
std::vector<FixedCurve> mapped(std::vector<FixedCurve> curves,
                               const ControlNet& given,
                               const Eigen::Matrix3d& map) {
  for (FixedCurve& curve : curves)
    curve.points = mapped(curve.points ? *curve.points : curvePoints(given, curve), map);
  return curves;
}

bool isInvertible(const Eigen::Matrix3d& map) {
  Eigen::FullPivLU<Eigen::Matrix3d> lu(map);
  lu.setThreshold(kFlattest);
  return map.allFinite() && lu.isInvertible();
}

Result<ConstrainedNet> startNet(const ControlNet& net,
                                const std::vector<FixedCurve>& curves,
                                PatchStart start) {
  auto constrained = constrain(start == PatchStart::Given ? net : coonsNet(net), curves);
  if (!constrained || start != PatchStart::Triharmonic) return constrained;
  const auto best = triharmonicNet(*constrained);
  if (!best) return fail(best.error());
  constrained->net = *best;
  return constrained;
}

}  // namespace

Result<BlendingResult> optimisePatch(const ControlNet& given,
                                     const PatchOptions& options,
                                     Progress* progress) {
  const Stopwatch watch;
  if (const auto valid = validate(given); !valid) return fail(valid.error());
  if (!isInvertible(options.transformation)) return fail({.code = ErrorCode::SystemSingular});
  // the curves' own parameters are checked before they are read
  if (const auto fits = constrain(given, options.curves); !fits) return fail(fits.error());
  const bool triharmonic = options.functional == PatchFunctional::Triharmonic;
  const ControlNet there = mapped(given, options.transformation);
  const auto start = startNet(there,
                              mapped(options.curves, given, options.transformation),
                              triharmonic ? PatchStart::Triharmonic : options.start);
  if (!start) return fail(start.error());
  BlendingResult result{start->net, {}};
  if (!triharmonic) {
    auto minimised = minimiseBlending(*start, options.blending, progress);
    if (!minimised) return minimised;
    result = std::move(*minimised);
  }
  result.net = mapped(result.net, options.transformation.inverse());
  BlendingReport report = measureBlending(
      result.net, parametrisationFactor(given, options.blending.weight), options.blending.threads);
  report.outcome = result.report.outcome;
  report.steps = std::move(result.report.steps);
  report.seconds = watch.total();
  result.report = std::move(report);
  return result;
}

}  // namespace fairing::uniform_patch
