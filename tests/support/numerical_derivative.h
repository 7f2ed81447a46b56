// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <type_traits>

namespace fairing::testing {

/// First derivative of f at x by central differences of fourth order. With steps of 1e-3 on
/// functions of size and scale 1 the truncation error is about 1e-12 and the rounding error 1e-13.
template <class Function>
[[nodiscard]] auto derivative(const Function& f, double x, double step = 1e-3) {
  using Value = std::decay_t<decltype(f(x))>;
  return Value((8.0 * (f(x + step) - f(x - step)) - (f(x + 2.0 * step) - f(x - 2.0 * step))) /
               (12.0 * step));
}

/// Gradient of a QUADRATIC function: central differences of any step are exact but for rounding.
template <class Function>
[[nodiscard]] Eigen::VectorXd quadraticGradient(const Function& f, const Eigen::VectorXd& x) {
  Eigen::VectorXd gradient(x.size()), moved = x;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    moved[k] = x[k] + 1.0;
    const double above = f(moved);
    moved[k] = x[k] - 1.0;
    gradient[k] = 0.5 * (above - f(moved));
    moved[k] = x[k];
  }
  return gradient;
}

}  // namespace fairing::testing
