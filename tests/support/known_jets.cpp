// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/known_jets.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace fairing::testing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using spline::ThirdOrderJet;

constexpr double kQuarter = 0.5 * std::numbers::pi;  // a derivative turns sine and cosine by it

constexpr std::array<std::pair<int, int>, 9> kOrders{
    {{1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}}};

}  // namespace

ThirdOrderJet revolvedJet(const Profile& profile, double u, double v) {
  ThirdOrderJet jet;
  for (std::size_t k = 0; k < kOrders.size(); ++k) {
    const auto [a, b] = kOrders[k];
    const Vector2d p = profile(v, b);
    const double angle = u + a * kQuarter;
    jet.col(static_cast<Eigen::Index>(k)) =
        Vector3d(p[0] * std::cos(angle), p[0] * std::sin(angle), a == 0 ? p[1] : 0.0);
  }
  return jet;
}

Profile sphereProfile(double radius) {
  return [=](double v, int order) {
    const double angle = v + order * kQuarter;
    return Vector2d(radius * std::cos(angle), radius * std::sin(angle));
  };
}

Profile cylinderProfile(double radius) {
  return [=](double v, int order) {
    return order == 0 ? Vector2d(radius, v) : Vector2d(0.0, order == 1 ? 1.0 : 0.0);
  };
}

Profile torusProfile(double ring, double tube) {
  return [=, circle = sphereProfile(tube)](double v, int order) {
    const Vector2d p = circle(v, order);
    return order == 0 ? Vector2d(ring + p[0], p[1]) : p;
  };
}

ThirdOrderJet randomJet(Random& random) {
  ThirdOrderJet jet = randomMatrix(random, 3, 9);
  jet.leftCols<2>() *= 0.3;
  jet.topLeftCorner<2, 2>() += Eigen::Matrix2d::Identity();
  return jet;
}

ThirdOrderJet reparametrised(const ThirdOrderJet& jet, const Eigen::Matrix2d& change) {
  // Symmetric tensors: every index is transformed by itself. A column is found by its number of v.
  constexpr std::array<Eigen::Index, 4> kFirstColumn{0, 0, 2, 5};  // by order
  ThirdOrderJet result = ThirdOrderJet::Zero();
  for (unsigned order = 1; order <= 3; ++order)
    for (unsigned to = 0; to <= order; ++to)  // the first order - `to` indices are s, others t
      for (unsigned bits = 0; bits < (1U << order); ++bits) {
        double factor = 1.0;
        Eigen::Index vs = 0;
        for (unsigned i = 0; i < order; ++i) {
          const Eigen::Index from = (bits >> i) & 1U;
          vs += from;
          factor *= change(from, i < order - to ? 0 : 1);
        }
        result.col(kFirstColumn[order] + to) += factor * jet.col(kFirstColumn[order] + vs);
      }
  return result;
}

}  // namespace fairing::testing
