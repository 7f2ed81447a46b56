// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace fairing {

enum class EnergyKind {
  Membrane,   ///< integral of |R_u|^2 + |R_v|^2, [WuYang2015] eq. 1
  ThinPlate,  ///< integral of |R_uu|^2 + 2 |R_uv|^2 + |R_vv|^2, [WuYang2015] eq. 2
  /// integral of |grad H|^2 over the surface itself, whatever its parameters [Kiciak2011]; started
  /// from ThinPlate
  MeanCurvatureGradient,
};

}  // namespace fairing
