// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace fairing {

enum class EnergyKind {
  Membrane,   ///< integral of |R_u|^2 + |R_v|^2, [WuYang2015] eq. 1
  ThinPlate,  ///< integral of |R_uu|^2 + 2 |R_uv|^2 + |R_vv|^2, [WuYang2015] eq. 2
  /// integral of |grad H|^2 over the surface itself, whatever its parameters [Kiciak2011]; started
  /// from ThinPlate
  MeanCurvatureGradient,
  /// the same, taken to its minimum: the one above stops after a few steps towards it
  MeanCurvatureGradientMinimum,
  /// integral of (dk1/de1)^2 + (dk2/de2)^2 over the surface, along the lines of curvature
  /// [MoretonSequin1992]; started from ThinPlate
  MinimumVariation,
  /// integral of k1^2 + k2^2 over the surface [MoretonSequin1992]; started from ThinPlate
  TotalCurvature,
  Triharmonic,  ///< integral of |grad laplace R|^2 over the parameters, T of [Kiciak2011] 3
};

}  // namespace fairing
