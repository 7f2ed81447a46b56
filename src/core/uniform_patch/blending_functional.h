// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/solver/band_matrix.h"
#include "core/uniform_patch/blending_integrand.h"
#include "core/uniform_patch/control_net.h"
#include "core/uniform_patch/free_points.h"
#include "core/uniform_patch/hessian_product.h"
#include "core/uniform_patch/span_quadrature.h"

namespace fairing::uniform_patch {

/// F = S + c Q about given points: F(y + d) ~ value + gradient . d + 1/2 d' hessian d, d the
/// coordinates of the free points, 3 a point. The hessian is the exact one, seldom definite.
struct BlendingModel {
  double value = 0.0;
  Eigen::VectorXd gradient;
  solver::BandMatrix hessian;
};

/// The blending functional F = S + c Q of [Kiciak2011] section 4 as a function of the free points
/// of a net, by Gauss-Legendre with so many points a span and direction. The result does not depend
/// on the number of threads, to the last bit.
class BlendingFunctional {
 public:
  /// `net` gives the sizes; c in mm^-4.
  BlendingFunctional(
      const ControlNet& net, const FreePoints& free, double c, int pointsPerSpan, int threads);

  /// S and Q of a net's points. Not finite where a normal vanishes.
  [[nodiscard]] BlendingValue<double> value(const spline::Poles& points) const;
  /// F = S + c Q of them.
  [[nodiscard]] double total(const spline::Poles& points) const;
  [[nodiscard]] BlendingModel model(const spline::Poles& points) const;
  [[nodiscard]] Eigen::VectorXd gradient(const spline::Poles& points) const;
  [[nodiscard]] int threads() const { return threads_; }

 private:
  struct Batch;
  using LaneRows = Eigen::Matrix<double, Eigen::Dynamic, 3 * kLanes, Eigen::RowMajor>;

  template <class Visit>
  void forEachRow(const Visit& visit) const;
  [[nodiscard]] LaneRows jetsOf(const spline::Poles& points, const Batch& batch) const;
  void addGradient(const LaneRows& slopes, const Batch& batch, Eigen::VectorXd& gradient) const;
  void addHessian(const HessianProduct& product,
                  const Batch& batch,
                  solver::BandMatrix& hessian) const;

  int rows_, columns_;
  const FreePoints* free_;
  double c_;
  SpanQuadrature quadrature_;
  int threads_, width_;
};

}  // namespace fairing::uniform_patch
