// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <functional>

#include "core/boundary/boundary_loop.h"
#include "core/spline/bspline_surface.h"
#include "support/known_surface.h"

namespace fairing::testing {

/// A curve in a surface's parameters with its derivative, t in [0, 1].
struct TracePoint {
  Eigen::Vector2d point, derivative;
};
using Trace = std::function<TracePoint(double t)>;

/// The straight line between two parameter points.
[[nodiscard]] Trace line(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
/// The same line bulged sideways by `bulge` times its length in its middle: not isoparametric.
[[nodiscard]] Trace bow(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double bulge);

/// One side along a surface; edge and face number 1 + index.
[[nodiscard]] boundary::BoundarySide sideOn(const KnownSurface& surface,
                                            const Trace& trace,
                                            int index);

using Sides = std::vector<boundary::BoundarySide>;

/// Four sides counter-clockwise round the parameter quadrilateral, all supported by one surface.
[[nodiscard]] Sides sidesOf(const KnownSurface& surface,
                            const std::array<Eigen::Vector2d, 4>& corners,
                            double bulge = 0.0);
/// The same as a finished loop (asserts that it is one).
[[nodiscard]] boundary::BoundaryLoop loopOf(const KnownSurface& surface,
                                            const std::array<Eigen::Vector2d, 4>& corners,
                                            double bulge = 0.0);
/// The rectangle [u0, u1] x [v0, v1] of a surface's parameters.
[[nodiscard]] std::array<Eigen::Vector2d, 4> rectangle(double u0, double u1, double v0, double v1);
/// The unit square.
[[nodiscard]] std::array<Eigen::Vector2d, 4> unitSquare();
/// A quadrilateral without parallel or equal sides.
[[nodiscard]] std::array<Eigen::Vector2d, 4> unevenQuadrilateral();

/// The border of a B-spline patch over [0, 1]^2 as polynomial sides, supported by the patch.
[[nodiscard]] Sides borderOf(const spline::BsplineSurface& surface);

/// A loop whose neighbours' twists disagree at every corner: straight sides of the unit square,
/// the support planes turning about each by `turn` radians from its start to its end and all
/// starting level.
[[nodiscard]] Sides incompatibleTwists(double turn);

[[nodiscard]] boundary::BoundaryLoop finished(Sides sides);

/// A ribbon moved by a similarity (uniform scale allowed).
[[nodiscard]] Sides moved(const Sides& sides, const Eigen::Affine3d& similarity);
/// The same sides, the one numbered `first` coming first.
[[nodiscard]] Sides startingAt(const Sides& sides, std::size_t first);
/// The same hole run through the other way, support normals turned so that it lies to the left.
[[nodiscard]] Sides turnedRound(const Sides& sides);

}  // namespace fairing::testing
