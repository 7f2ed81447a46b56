// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <functional>

#include "core/uniform_patch/control_net.h"

namespace fairing::testing {

/// A net of n x m control points: d_ij = f(u, v), u and v from -1 to 1 between the second points of
/// either side, which lie near the border.
[[nodiscard]] uniform_patch::ControlNet netOf(
    int n, int m, const std::function<Eigen::Vector3d(double u, double v)>& f);

/// A wave over a square: nothing special anywhere, far from any minimum.
[[nodiscard]] uniform_patch::ControlNet waveNet(int n, int m);

/// The net of the patch that IS a cubic polynomial in u and v over the domain of the same knots:
/// every control point is the polynomial's blossom at three knots of either direction.
[[nodiscard]] uniform_patch::ControlNet cubicNet(int n, int m);
/// The cubic polynomial.
[[nodiscard]] Eigen::Vector3d cubicSurface(double u, double v);

/// A plateau over a square with steep sides all round: the shape that grows a hernia.
[[nodiscard]] uniform_patch::ControlNet plateauNet(int n);

/// The same rings with random inner points, moved by up to `size`.
[[nodiscard]] uniform_patch::ControlNet disturbed(uniform_patch::ControlNet net,
                                                  double size,
                                                  unsigned seed = 0);

}  // namespace fairing::testing
