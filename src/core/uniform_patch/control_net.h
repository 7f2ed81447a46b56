// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "core/base/result.h"
#include "core/spline/bspline_curve.h"

namespace fairing::uniform_patch {

/// How many outer rings of control points a net is given with: they fix position, tangent plane and
/// curvature along the border of the patch.
inline constexpr int kRings = 3;

/// A bicubic B-spline patch on the knots 0, 1, 2, ... in either direction, not clamped
/// [Kiciak2011] section 2:
///   p(u, v) = sum_ij N_i(u) N_j(v) d_ij   over   [3, rows] x [3, columns],
/// one span per unit square. It is C2, and its control points near a side do not lie on it.
struct ControlNet {
  int rows = 0;          ///< control points along u
  int columns = 0;       ///< control points along v
  spline::Poles points;  ///< d_ij is row i * columns + j, mm

  [[nodiscard]] int index(int i, int j) const { return i * columns + j; }
  [[nodiscard]] int spansU() const { return rows - 3; }
  [[nodiscard]] int spansV() const { return columns - 3; }
  /// The control points that move span (i, j): number 4 * k + l is d_(i + k, j + l).
  [[nodiscard]] std::array<int, 16> spanPoints(int i, int j) const {
    std::array<int, 16> numbers{};
    for (int k = 0; k < 16; ++k) numbers[std::size_t(k)] = index(i + k / 4, j + k % 4);
    return numbers;
  }
  /// Whether d_ij lies inside the given rings.
  [[nodiscard]] bool isInner(int i, int j) const {
    return std::min({i, j, rows - 1 - i, columns - 1 - j}) >= kRings;
  }
};

/// Calls visit(spanPoints(i, j)) for every span, those of one i after the other.
template <class Visit>
void forEachSpan(const ControlNet& net, const Visit& visit) {
  for (int i = 0; i < net.spansU(); ++i)
    for (int j = 0; j < net.spansV(); ++j) visit(net.spanPoints(i, j));
}

/// Fails with NetTooSmall if no point lies inside the rings, with NotFinite at a coordinate that is
/// not a number.
[[nodiscard]] Result<void> validate(const ControlNet& net);

/// d^(a+b) p / du^a dv^b at parameters of the domain, orders up to 3.
[[nodiscard]] Eigen::Vector3d evaluate(
    const ControlNet& net, double u, double v, int a = 0, int b = 0);

/// Largest distance of two points of the patch's border, taken where its knots are, mm.
[[nodiscard]] double borderDiameter(const ControlNet& net);

/// The net with its inner points blended bilinearly from the innermost ring (Coons). It does not
/// read the inner points.
[[nodiscard]] ControlNet coonsNet(const ControlNet& net);

}  // namespace fairing::uniform_patch
