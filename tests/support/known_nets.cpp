// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/known_nets.h"

#include <cmath>
#include <random>

namespace fairing::testing {

using Eigen::Vector3d;
using uniform_patch::ControlNet;

namespace {

// The blossoms of 1, t, t^2 and t^3 at the knots k + 1, k + 2, k + 3, which give control point k.
Eigen::Vector4d powers(int k) {
  const double a = k + 1.0, b = k + 2.0, c = k + 3.0;
  return {1.0, (a + b + c) / 3.0, (a * b + b * c + c * a) / 3.0, a * b * c};
}

// Coefficients of u^a v^b of a coordinate, of size 1 over a domain of ten spans.
double coefficient(int a, int b, int c) {
  return std::sin(1.0 + a + 2.7 * b + 1.3 * c) * std::pow(0.1, a + b) +
         (c == a && a + b == 1 ? 1.0 : 0.0) + (c == 1 && a == 0 && b == 1 ? 1.0 : 0.0);
}

Vector3d cubicOf(const Eigen::Vector4d& u, const Eigen::Vector4d& v) {
  Vector3d sum = Vector3d::Zero();
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      for (int c = 0; c < 3; ++c) sum[c] += coefficient(a, b, c) * u[a] * v[b];
  return sum;
}

}  // namespace

ControlNet netOf(int n, int m, const std::function<Vector3d(double u, double v)>& f) {
  ControlNet net{n, m, spline::Poles(n * m, 3)};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      net.points.row(net.index(i, j)) =
          f(2.0 * (i - 1) / (n - 3) - 1.0, 2.0 * (j - 1) / (m - 3) - 1.0);
  return net;
}

ControlNet waveNet(int n, int m) {
  return netOf(n, m, [](double u, double v) {
    return Vector3d(
        u, v + 0.1 * u * u, 0.3 * std::sin(2.0 * u + 0.5) * std::cos(2.5 * v) + 0.1 * u);
  });
}

ControlNet cubicNet(int n, int m) {
  ControlNet net{n, m, spline::Poles(n * m, 3)};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) net.points.row(net.index(i, j)) = cubicOf(powers(i), powers(j));
  return net;
}

Vector3d cubicSurface(double u, double v) {
  return cubicOf({1.0, u, u * u, u * u * u}, {1.0, v, v * v, v * v * v});
}

ControlNet plateauNet(int n) {
  return netOf(n, n, [](double u, double v) {
    return Vector3d(u, v, std::tanh(3.0 * (1.0 - u * u)) * std::tanh(3.0 * (1.0 - v * v)));
  });
}

ControlNet disturbed(ControlNet net, double size, unsigned seed) {
  std::mt19937 generator{seed};
  std::uniform_real_distribution<double> by(-size, size);
  for (int i = 0; i < net.rows; ++i)
    for (int j = 0; j < net.columns; ++j)
      if (net.isInner(i, j))
        for (int c = 0; c < 3; ++c) net.points(net.index(i, j), c) += by(generator);
  return net;
}

}  // namespace fairing::testing
