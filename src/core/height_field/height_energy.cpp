// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/height_energy.h"

#include <array>
#include <cmath>

namespace fairing::height_field {
namespace {

// Of the energy outside the loop: enough to settle the poles there, too little to be felt inside.
constexpr double kOutside = 1e-6;
// Of the squares of all third derivatives beside those of the Laplacian's gradient: without them
// harmonic waves would cost nothing. In a Gauss-Newton step they hold the step back, not the shape.
constexpr double kAllThirds = 1e-3;

JetForm form(std::initializer_list<std::pair<JetIndex, double>> terms) {
  JetForm result = JetForm::Zero();
  for (const auto& [index, factor] : terms) result[index] = factor;
  return result;
}

std::vector<EnergySquare> allThirds(double weight) {
  return {{form({{Huuu, 1.0}}), 0.0, weight},
          {form({{Huuv, 1.0}}), 0.0, 3.0 * weight},
          {form({{Huvv, 1.0}}), 0.0, 3.0 * weight},
          {form({{Hvvv, 1.0}}), 0.0, weight}};
}

// A value and its derivatives with respect to the jet.
struct Dual {
  double value = 0.0;
  JetForm slope = JetForm::Zero();
  Dual(double v) : value(v) {}  // NOLINT: constants mix with duals
  Dual(double v, JetForm s) : value(v), slope(std::move(s)) {}
  static Dual of(const Jet& jet, JetIndex index) { return {jet[index], JetForm::Unit(index)}; }
};
Dual operator+(const Dual& a, const Dual& b) {
  return {a.value + b.value, a.slope + b.slope};
}
Dual operator-(const Dual& a, const Dual& b) {
  return {a.value - b.value, a.slope - b.slope};
}
Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.value * b.slope + b.value * a.slope};
}
Dual power(const Dual& a, double exponent) {
  const double p = std::pow(a.value, exponent - 1.0);
  return {p * a.value, exponent * p * a.slope};
}

// With p = h_u, q = h_v, W^2 = 1 + p^2 + q^2 and  N = (1 + q^2) h_uu - 2 p q h_uv + (1 + p^2) h_vv:
//   H = N / (2 W^3),  |grad H|^2 dA = W (|dH|^2 - (p H_u + q H_v)^2 / W^2) du dv.
// The root of the inverse metric is  I - (p, q)(p, q)' / (W (W + 1)).
std::array<Dual, 2> residuals(const Jet& jet) {
  const auto d = [&](JetIndex index) { return Dual::of(jet, index); };
  const Dual p = d(Hu), q = d(Hv), r = d(Huu), s = d(Huv), t = d(Hvv);
  const Dual w2 = 1.0 + p * p + q * q, w = power(w2, 0.5), w3 = w2 * w;
  const Dual a = 1.0 + q * q, b = p * q, c = 1.0 + p * p;
  const Dual n = a * r - 2.0 * b * s + c * t;
  // Derivatives of N and W^2 along u and v.
  const auto gradient =
      [&](const Dual& pd, const Dual& qd, const Dual& rd, const Dual& sd, const Dual& td) {
        const Dual nd = 2.0 * q * qd * r + a * rd - 2.0 * (pd * q + p * qd) * s - 2.0 * b * sd +
                        2.0 * p * pd * t + c * td;
        const Dual w2d = 2.0 * (p * pd + q * qd);
        return 0.5 * (nd - 1.5 * n * w2d * power(w2, -1.0)) * power(w3, -1.0);
      };
  const Dual alongU = gradient(r, s, d(Huuu), d(Huuv), d(Huvv));
  const Dual alongV = gradient(s, t, d(Huuv), d(Huvv), d(Hvvv));
  const Dual steep = (p * alongU + q * alongV) * power(w * (w + 1.0), -1.0);
  const Dual root = power(w, 0.5);
  // H is half the sum of curvatures: doubled, so that a level surface has |grad laplace h|^2.
  return {2.0 * root * (alongU - p * steep), 2.0 * root * (alongV - q * steep)};
}

}  // namespace

std::vector<EnergySquare> quadraticSquares(EnergyKind kind) {
  switch (kind) {
    case EnergyKind::Membrane:
      return {{form({{Hu, 1.0}})}, {form({{Hv, 1.0}})}};
    case EnergyKind::ThinPlate:
    case EnergyKind::TotalCurvature:
      return {{form({{Huu, 1.0}})}, {form({{Huv, 1.0}}), 0.0, 2.0}, {form({{Hvv, 1.0}})}};
    case EnergyKind::MinimumVariation:
      return {{form({{Huuu, 1.0}, {Huvv, 1.0}}), 0.0, 9.0 / 16.0},
              {form({{Huuv, 1.0}, {Hvvv, 1.0}}), 0.0, 9.0 / 16.0},
              {form({{Huuu, 1.0}, {Huvv, -3.0}}), 0.0, 1.0 / 16.0},
              {form({{Hvvv, 1.0}, {Huuv, -3.0}}), 0.0, 1.0 / 16.0}};
    case EnergyKind::MeanCurvatureGradient:
    case EnergyKind::MeanCurvatureGradientMinimum:
    case EnergyKind::Triharmonic:
      break;
  }
  std::vector<EnergySquare> squares = allThirds(kAllThirds);
  squares.push_back({form({{Huuu, 1.0}, {Huvv, 1.0}})});
  squares.push_back({form({{Huuv, 1.0}, {Hvvv, 1.0}})});
  return squares;
}

bool isLinearised(EnergyKind kind) {
  return kind == EnergyKind::MeanCurvatureGradient ||
         kind == EnergyKind::MeanCurvatureGradientMinimum;
}

std::vector<EnergySquare> meanCurvatureGradientSquares(const Jet& jet) {
  std::vector<EnergySquare> squares = allThirds(kAllThirds);
  for (EnergySquare& square : squares) square.right = square.form.dot(jet);
  for (const Dual& residual : residuals(jet))
    squares.push_back({residual.slope, residual.slope.dot(jet) - residual.value});
  return squares;
}

void addEnergy(HeightSystem& system,
               const DomainGrid& grid,
               EnergyKind kind,
               const Heights* about) {
  const std::vector<EnergySquare> quadratic = quadraticSquares(kind);
  const bool linearised = about != nullptr && isLinearised(kind);
  CellSquares cell;
  const auto addAll = [&](const JetBasis& at, std::vector<EnergySquare> squares, double weight) {
    for (EnergySquare& square : squares) {
      square.weight *= weight;
      cell.add(at, square);
    }
  };
  grid.visit(
      [&](const DomainGrid::Place& place) {
        const JetBasis at = jetBasis(place.basisU, place.basisV);
        if (!place.inside) return addAll(at, quadratic, kOutside * place.weight);
        if (!linearised) return addAll(at, quadratic, place.weight);
        addAll(at, meanCurvatureGradientSquares(about->jet(place.u, place.v)), place.weight);
      },
      [&] {
        system.addEnergy(cell);
        cell = {};
      });
}

double shapeEnergy(const DomainGrid& grid, const Heights& heights) {
  double sum = 0.0;
  grid.visit(
      [&](const DomainGrid::Place& place) {
        if (!place.inside) return;
        for (const Dual& residual : residuals(heights.jet(jetBasis(place.basisU, place.basisV))))
          sum += place.weight * residual.value * residual.value;
      },
      [] {});
  return sum;
}

}  // namespace fairing::height_field
