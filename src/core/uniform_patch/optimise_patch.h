// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/uniform_patch/minimise_blending.h"

namespace fairing::uniform_patch {

/// Where the shape's functional is minimised from.
enum class PatchStart {
  Triharmonic,  ///< the minimiser of T, as good as always the best
  Coons,        ///< blended bilinearly from the innermost ring
  Given,        ///< the given net's own inner points
};

enum class PatchFunctional {
  Triharmonic,  ///< T alone, [Kiciak2011] section 3: a linear system
  Blending,     ///< F = S + c Q, [Kiciak2011] section 4
};

struct PatchOptions {
  PatchFunctional functional = PatchFunctional::Blending;
  PatchStart start = PatchStart::Triharmonic;
  std::vector<FixedCurve> curves;
  /// The patch is optimised in space mapped by this, and mapped back: a remedy for hernias
  /// [Kiciak2011] section 5. T does not mind it.
  Eigen::Matrix3d transformation = Eigen::Matrix3d::Identity();
  BlendingOptions blending;
};

/// The patch of a net's three outer rings with the best shape. Steps are reported in the mapped
/// space; S, Q, T and c as they are of the patch that is returned. Fails as constrain() and
/// minimiseBlending() do, and with SystemSingular if the
/// transformation has no inverse.
[[nodiscard]] Result<BlendingResult> optimisePatch(const ControlNet& given,
                                                   const PatchOptions& options = {},
                                                   Progress* progress = nullptr);

}  // namespace fairing::uniform_patch
