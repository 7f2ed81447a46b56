// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/quantities.h"

#include <fmt/format.h>

#include <cmath>

namespace fairing::text {
namespace {

/// Smaller than any length a model can mean: shown as zero.
constexpr double kNothing = 1e-12;

std::string digits(double value, int count) {
  return fmt::format("{:.{}g}", value, count);
}

}  // namespace

std::string length(double mm) {
  const double size = std::abs(mm);
  if (std::isnan(mm)) return "NaN";
  if (size < kNothing) return "0 mm";
  if (size < 1e-6) return digits(mm * 1e6, 2) + " nm";
  if (size < 1e-3) return digits(mm * 1e6, 3) + " nm";
  if (size < 0.1) return digits(mm * 1e3, 3) + " \u00b5m";
  return digits(mm, 4) + " mm";
}

std::string angle(double degrees) {
  if (std::isnan(degrees)) return "NaN";
  if (std::abs(degrees) < 1e-5) return "0\u00b0";
  return digits(degrees, 2) + "\u00b0";
}

std::string percent(double share) {
  if (std::isnan(share)) return "NaN";
  if (std::abs(share) < 1e-5) return "0 %";
  return fmt::format("{:.{}f} %", 100.0 * share, share < 0.001 ? 3 : share < 0.1 ? 1 : 0);
}

std::string point(const Eigen::Vector3d& where) {
  const auto coordinate = [&](double x) {
    return digits(std::abs(x) < 1e-9 * where.norm() ? 0.0 : x, 5);
  };
  return fmt::format(
      "({}, {}, {})", coordinate(where.x()), coordinate(where.y()), coordinate(where.z()));
}

std::string number(double value) {
  return std::isnan(value) ? "NaN" : digits(value, 4);
}

}  // namespace fairing::text
