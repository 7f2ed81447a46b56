// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/blending_functional.h"

#include <vector>

#include "core/base/parallel_for.h"
#include "core/spline/surface_grid.h"
#include "core/uniform_patch/hessian_product.h"

// Spans that follow each other along v are worked on together, one a lane: the knots are uniform,
// so they share the basis functions and the weights.
//
// Rows of spans run in parallel. Two of them touch no common pair of control points if four or more
// apart; rows are taken modulo four, one class after the other, which makes every sum's order the
// same whatever the number of threads.

namespace fairing::uniform_patch {

// kLanes spans of one row, the last ones repeated where the row ends.
struct BlendingFunctional::Batch {
  int row, first, used;
  [[nodiscard]] int column(int lane) const { return first + std::min(lane, used - 1); }
};

namespace {

JetOf<Lanes> jetAt(const double* numbers) {
  JetOf<Lanes> jet;
  for (std::size_t k = 0; k < jet.size(); ++k)
    jet[k] = Eigen::Map<const Lanes>(numbers + k * kLanes);
  return jet;
}

double sumOf(const Lanes& lanes, int used) {
  double sum = 0.0;
  for (int s = 0; s < used; ++s) sum += lanes[s];
  return sum;
}

// In place of a jet, what F changes by with it.
void putSlopes(const BlendingDerivatives<Lanes>& at, double weight, double* numbers) {
  for (std::size_t k = 0; k < 27; ++k)
    Eigen::Map<Lanes>(numbers + k * kLanes) = weight * at.gradient[k];
}

}  // namespace

BlendingFunctional::BlendingFunctional(
    const ControlNet& net, const FreePoints& free, double c, int pointsPerSpan, int threads)
    : rows_(net.rows),
      columns_(net.columns),
      free_(&free),
      c_(c),
      quadrature_(pointsPerSpan),
      threads_(threads),
      width_(3 * free.couplingWidth(net) + 2) {}

template <class Visit>
void BlendingFunctional::forEachRow(const Visit& visit) const {
  const int rows = rows_ - 3, spans = columns_ - 3;
  for (int colour = 0; colour < 4; ++colour)
    parallelFor(threads_, (rows - colour + 3) / 4, [&](int k) {
      const int row = 4 * k + colour;
      for (int first = 0; first < spans; first += kLanes)
        visit(Batch{row, first, std::min(kLanes, spans - first)});
    });
}

BlendingFunctional::LaneRows BlendingFunctional::jetsOf(const spline::Poles& points,
                                                        const Batch& batch) const {
  Eigen::Matrix<double, 16, 3 * kLanes, Eigen::RowMajor> poles;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int s = 0; s < kLanes; ++s)
        for (int c = 0; c < 3; ++c)
          poles(4 * i + j, c * kLanes + s) =
              points((batch.row + i) * columns_ + batch.column(s) + j, c);
  return quadrature_.jets * poles;
}

BlendingValue<double> BlendingFunctional::value(const spline::Poles& points) const {
  std::vector<BlendingValue<double>> ofRow(std::size_t(rows_ - 3), {0.0, 0.0});
  const int n = quadrature_.n;
  forEachRow([&](const Batch& batch) {
    const LaneRows jets = jetsOf(points, batch);
    BlendingValue<double>& sum = ofRow[std::size_t(batch.row)];
    for (int p = 0; p < n; ++p)
      for (int q = 0; q < n; ++q) {
        const double weight = quadrature_.weight(p, q);
        const BlendingValue<Lanes> at =
            blendingValue(jetAt(jets.row(9 * quadrature_.index(p, q)).data()));
        sum.shape += weight * sumOf(at.shape, batch.used);
        sum.parametrisation += weight * sumOf(at.parametrisation, batch.used);
      }
  });
  BlendingValue<double> sum{0.0, 0.0};
  for (const BlendingValue<double>& row : ofRow) {
    sum.shape += row.shape;
    sum.parametrisation += row.parametrisation;
  }
  return sum;
}

double BlendingFunctional::total(const spline::Poles& points) const {
  const BlendingValue<double> at = value(points);
  return at.shape + c_ * at.parametrisation;
}

void BlendingFunctional::addGradient(const LaneRows& slopes,
                                     const Batch& batch,
                                     Eigen::VectorXd& gradient) const {
  const Eigen::Matrix<double, 16, 3 * kLanes, Eigen::RowMajor> ofPoles =
      quadrature_.jets.transpose() * slopes;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int s = 0; s < batch.used; ++s) {
        const int point = (batch.row + i) * columns_ + batch.column(s) + j;
        for (const FreePoints::Term& term : free_->terms[std::size_t(point)])
          for (int c = 0; c < 3; ++c)
            gradient[3 * term.free + c] += term.factor * ofPoles(4 * i + j, c * kLanes + s);
      }
}

Eigen::VectorXd BlendingFunctional::gradient(const spline::Poles& points) const {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(3 * free_->count);
  const int n = quadrature_.n;
  forEachRow([&](const Batch& batch) {
    LaneRows jets = jetsOf(points, batch);
    BlendingDerivatives<Lanes> at;
    for (int p = 0; p < n; ++p)
      for (int q = 0; q < n; ++q) {
        const double weight = quadrature_.weight(p, q);
        double* numbers = jets.row(9 * quadrature_.index(p, q)).data();
        blendingGradient(jetAt(numbers), c_, at);
        putSlopes(at, weight, numbers);
      }
    addGradient(jets, batch, gradient);
  });
  return gradient;
}

BlendingModel BlendingFunctional::model(const spline::Poles& points) const {
  BlendingModel model{
      0.0, Eigen::VectorXd::Zero(3 * free_->count), solver::BandMatrix(3 * free_->count, width_)};
  std::vector<double> ofRow(std::size_t(rows_ - 3), 0.0);
  const int n = quadrature_.n;
  const HessianBasis basis(quadrature_);
  forEachRow([&](const Batch& batch) {
    LaneRows jets = jetsOf(points, batch);
    HessianProduct product(basis);
    BlendingDerivatives<Lanes> at;
    for (int p = 0; p < n; ++p) {
      for (int q = 0; q < n; ++q) {
        const double weight = quadrature_.weight(p, q);
        double* numbers = jets.row(9 * quadrature_.index(p, q)).data();
        blendingDerivatives(jetAt(numbers), c_, at);
        putSlopes(at, weight, numbers);
        product.set(q, at.hessian);
        ofRow[std::size_t(batch.row)] +=
            weight * sumOf(at.value.shape + c_ * at.value.parametrisation, batch.used);
      }
      product.finishLine(p);
    }
    product.finish();
    addGradient(jets, batch, model.gradient);
    addHessian(product, batch, model.hessian);
  });
  for (const double value : ofRow) model.value += value;
  return model;
}

void BlendingFunctional::addHessian(const HessianProduct& product,
                                    const Batch& batch,
                                    solver::BandMatrix& hessian) const {
  for (int s = 0; s < batch.used; ++s) {
    const auto termsOf = [&](int k) -> const std::vector<FreePoints::Term>& {
      return free_->terms[std::size_t((batch.row + k / 4) * columns_ + batch.column(s) + k % 4)];
    };
    for (int k = 0; k < 16; ++k)
      for (const FreePoints::Term& x : termsOf(k))
        for (int l = 0; l < 16; ++l)
          for (const FreePoints::Term& y : termsOf(l)) {
            if (x.free < y.free) continue;
            const double factor = x.factor * y.factor;
            for (int c = 0; c < 3; ++c)
              for (int d = 0; d < (x.free == y.free ? c + 1 : 3); ++d)
                hessian.at(3 * x.free + c, 3 * y.free + d) += factor * product.at(k, l, c, d, s);
          }
  }
}

}  // namespace fairing::uniform_patch
