// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/minimise_blending.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/stopwatch.h"
#include "core/spline/quadrature.h"
#include "core/uniform_patch/blending_functional.h"
#include "core/uniform_patch/damped_step.h"
#include "core/uniform_patch/triharmonic.h"

namespace fairing::uniform_patch {
namespace {

// Gauss points a span and direction. With 4 the minimum's F is exact to 2e-8, with 3 to 1e-7, on
// nets of 16 x 16 and more; what is reported is measured with 10.
constexpr int kPoints = 4, kPointsToMeasure = 10;

// Newton decrement at which F is at its minimum, beside F.
constexpr double kConverged = 1e-11;

// Corrections with an old factor: they go on while each promises this share of the one before.
constexpr double kCorrectionGain = 0.05;
constexpr int kMostCorrections = 8;

// F of spheres and planes is 0; this much of the border's diameter^-2 counts as nothing.
constexpr double kNoShape = 1e-9;

// A normal this short beside R_u and R_v, or one of these beside a span's share of the border, is
// none.
constexpr double kNoNormal = 1e-9;

// The parameters of the quadrature along one direction.
std::vector<double> quadratureParameters(int spans) {
  std::vector<double> parameters;
  for (int k = 0; k < spans; ++k)
    for (const spline::QuadraturePoint& point : spline::gaussLegendre(kPoints, 3.0 + k, 4.0 + k))
      parameters.push_back(point.parameter);
  return parameters;
}

Result<void> checkNormals(const ControlNet& net) {
  const double least = kNoNormal * borderDiameter(net) / (net.spansU() + net.spansV());
  const std::vector<double> vs = quadratureParameters(net.spansV());
  for (const double u : quadratureParameters(net.spansU()))
    for (const double v : vs) {
      const Eigen::Vector3d pu = evaluate(net, u, v, 1, 0), pv = evaluate(net, u, v, 0, 1);
      const bool hasNormal = std::min(pu.norm(), pv.norm()) > least &&
                             pu.cross(pv).norm() > kNoNormal * pu.norm() * pv.norm();
      if (!hasNormal)
        return fail({.code = ErrorCode::NormalVanishes, .where = evaluate(net, u, v)});
    }
  return {};
}

class Minimiser {
 public:
  Minimiser(const ConstrainedNet& start, const BlendingOptions& options, Progress* progress)
      : options_(options),
        progress_(progress),
        net_(start.net),
        functional_(start.net,
                    start.free,
                    parametrisationFactor(start.net, options.weight),
                    kPoints,
                    options.threads),
        search_(start, functional_, metricFactor(start.net)),
        least_(kNoShape / std::pow(borderDiameter(start.net), 2)) {}

  BlendingOutcome run() {
    while (true) {
      if (progress_ != nullptr && progress_->isAbortRequested()) return BlendingOutcome::Cancelled;
      if (static_cast<int>(steps_.size()) >= options_.stepLimit) return BlendingOutcome::StepLimit;
      const BlendingModel model = functional_.model(net_.points);
      const std::optional<DampedStep> step = search_.best(net_.points, model);
      if (!step) return BlendingOutcome::Stalled;
      steps_.push_back({.value = model.value,
                        .slope = model.gradient.norm(),
                        .damping = step->damping,
                        .factorisations = search_.factorisations()});
      const bool converged = step->damping == 0.0 && isNothing(step->promised, model.value);
      move(*step);
      if (converged || (step->damping == 0.0 && correct(*step))) return BlendingOutcome::Converged;
      if (progress_ != nullptr) progress_->setFraction(1.0 - 4.0 / (4.0 + double(steps_.size())));
    }
  }

  [[nodiscard]] const ControlNet& net() const { return net_; }
  [[nodiscard]] std::vector<BlendingStep> steps() const { return steps_; }

 private:
  // Damping is counted in what Q weighs with the usual C, whatever C is.
  static double metricFactor(const ControlNet& net) {
    return parametrisationFactor(net, BlendingOptions{}.weight);
  }
  [[nodiscard]] bool isNothing(double promised, double value) const {
    return promised <= kConverged * std::max(value, least_);
  }
  void move(const DampedStep& step) {
    net_.points = step.points;
    steps_.back().length = std::max(steps_.back().length, step.length);
  }

  // Newton's steps with the factor of the last second derivatives, each for the price of a
  // gradient. Whether nothing is left to gain.
  bool correct(const DampedStep& newton) {
    double value = newton.value, promised = newton.promised;
    for (int k = 0; k < kMostCorrections; ++k) {
      const DampedStep next =
          search_.along(net_.points, functional_.gradient(net_.points), *newton.factor);
      if (isNothing(next.promised, value)) return true;
      if (next.promised > kCorrectionGain * promised || !(next.value < value)) return false;
      move(next);
      ++steps_.back().corrections;
      value = next.value;
      promised = next.promised;
    }
    return false;
  }

  BlendingOptions options_;
  Progress* progress_;
  ControlNet net_;
  BlendingFunctional functional_;
  DampedSearch search_;
  double least_;
  std::vector<BlendingStep> steps_;
};

}  // namespace

double parametrisationFactor(const ControlNet& net, double weight) {
  const double domain2 = double(net.spansU()) * net.spansU() + double(net.spansV()) * net.spansV();
  return weight * std::pow(domain2, 2) / std::pow(borderDiameter(net), 4);
}

BlendingReport measureBlending(const ControlNet& net, double c, int threads) {
  const FreePoints none{std::vector<std::vector<FreePoints::Term>>(std::size_t(net.points.rows())),
                        0};
  const BlendingFunctional functional(net, none, c, kPointsToMeasure, threads);
  const BlendingValue<double> value = functional.value(net.points);
  BlendingReport report;
  report.c = c;
  report.triharmonic = triharmonicEnergy(net);
  report.shape = value.shape;
  report.parametrisation = value.parametrisation;
  return report;
}

Result<BlendingResult> minimiseBlending(const ConstrainedNet& start,
                                        const BlendingOptions& options,
                                        Progress* progress) {
  if (!(options.weight >= 0.0))
    return fail({.code = ErrorCode::WeightNegative, .value = options.weight, .detail = "C"});
  if (const auto regular = checkNormals(start.net); !regular) return fail(regular.error());
  const Stopwatch watch;
  BlendingOutcome outcome = BlendingOutcome::Converged;
  Minimiser minimiser(start, options, progress);
  if (start.free.count > 0) outcome = minimiser.run();
  BlendingReport report = measureBlending(
      minimiser.net(), parametrisationFactor(start.net, options.weight), options.threads);
  report.outcome = outcome;
  report.steps = minimiser.steps();
  report.seconds = watch.total();
  return BlendingResult{minimiser.net(), std::move(report)};
}

}  // namespace fairing::uniform_patch
