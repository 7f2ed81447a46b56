// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/energy/guidance.h"
#include "core/layout/patch_layout.h"
#include "core/solver/quadratic_program.h"
#include "core/spline/bspline_surface.h"

namespace fairing::assembly {

/// The guided part of an energy over n points,
///   1/2 sum_q w_q { lambda_q [(R_u . N_q)^2 + (R_v . N_q)^2] + gamma_q (R - S_q)^2 },
/// as matrices and load of a quadratic program.
struct GuidanceSystem {
  solver::Sparse normals;  ///< 3n x 3n: the part of lambda
  solver::Sparse points;   ///< n x n, the same for the three coordinates: the part of gamma
  Eigen::VectorXd load;    ///< 3n, of gamma
  double constant = 0.0;   ///< 1/2 sum w gamma S^2: what the quadratic form leaves out

  /// Both parts in all coordinates, 3n x 3n.
  [[nodiscard]] solver::Sparse coupled() const;
};

/// Assembles every form of guidance the user gave ([WuYang2015] sections 2 to 4). Handles, curves
/// and the reference shape are looked up near `current`, the patches of the last solve.
[[nodiscard]] GuidanceSystem assembleGuidance(const layout::PatchLayout& layout,
                                              const energy::Guidance& guidance,
                                              const std::vector<spline::BsplineSurface>& current);

}  // namespace fairing::assembly
