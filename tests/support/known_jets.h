// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <functional>

#include "core/spline/fundamental_forms.h"
#include "support/random_splines.h"

namespace fairing::testing {

/// A profile curve's distance from the axis and its height, differentiated `order` times.
using Profile = std::function<Eigen::Vector2d(double v, int order)>;

/// The jet of the surface that a profile sweeps about the z axis, exact to rounding; u is the
/// angle.
[[nodiscard]] spline::ThirdOrderJet revolvedJet(const Profile& profile, double u, double v);

/// Profiles of latitude v, of height v and of the tube's angle v.
[[nodiscard]] Profile sphereProfile(double radius);
[[nodiscard]] Profile cylinderProfile(double radius);
[[nodiscard]] Profile torusProfile(double ring, double tube);

/// Near a level square, every derivative of size 1: a regular point of no special shape.
[[nodiscard]] spline::ThirdOrderJet randomJet(Random& random);

/// The jet of the same surface in parameters (s, t), (u, v) = change (s, t).
[[nodiscard]] spline::ThirdOrderJet reparametrised(const spline::ThirdOrderJet& jet,
                                                   const Eigen::Matrix2d& change);

}  // namespace fairing::testing
