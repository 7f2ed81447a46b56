// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <array>

namespace fairing::uniform_patch {

/// Points that are worked on together, one a lane: what a processor does to several numbers at
/// once.
inline constexpr int kLanes = 4;
using Lanes = Eigen::Array<double, kLanes, 1>;

/// Entry (k, c) of a third order jet (spline::ThirdOrderJet) is number 3 * k + c.
template <class Number>
using JetOf = std::array<Number, 27>;

/// Both integrands of the blending functional F = S + c Q at points of a patch, per unit of the
/// parameters [Kiciak2011] section 4:
///   S: |grad H|^2 times the area element, of the shape alone;
///   Q: |P grad lap p|^2, P the projection onto the tangent plane, of the parametrisation.
/// Not finite where R_u x R_v vanishes.
template <class Number>
struct BlendingValue {
  Number shape, parametrisation;
};

/// S + c Q with its first and second derivatives with respect to the jet, exact.
template <class Number>
struct BlendingDerivatives {
  BlendingValue<Number> value;
  JetOf<Number> gradient;
  /// Block (k, l), l <= k, of 3 x 3 numbers, row by row: number 9 * blockIndex(k, l) + 3 * c + d
  /// stands for entry (k, c) and entry (l, d) of the jet.
  std::array<Number, 405> hessian;

  [[nodiscard]] static constexpr int blockIndex(int k, int l) { return k * (k + 1) / 2 + l; }
};

/// Number: double or Lanes.
template <class Number>
[[nodiscard]] BlendingValue<Number> blendingValue(const JetOf<Number>& jet);
/// Overwrites `result`; no heap.
template <class Number>
void blendingDerivatives(const JetOf<Number>& jet, double c, BlendingDerivatives<Number>& result);

/// The gradient alone, at a tenth of the cost: `result.hessian` is left as it was.
template <class Number>
void blendingGradient(const JetOf<Number>& jet, double c, BlendingDerivatives<Number>& result);

}  // namespace fairing::uniform_patch
