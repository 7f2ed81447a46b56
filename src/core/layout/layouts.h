// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/base/result.h"
#include "core/layout/patch_layout.h"

namespace fairing::layout {

struct LayoutOptions {
  LayoutKind kind = LayoutKind::Auto;
  int degree = 0;             ///< 0 = chosen from the sides
  double fitTolerance = 0.0;  ///< mm, for sides that are not polynomial
  int maxPoles = 10000;       ///< of all patches
};

/// The coarsest layout of the asked kind; the one list of the choices. Auto takes the kind that
/// suits the loop.
[[nodiscard]] Result<PatchLayout> makeLayout(const boundary::BoundaryLoop& loop,
                                             const LayoutOptions& options);

/// Knots to add to one patch, in its parameters.
struct KnotWish {
  std::vector<double> u, v;
  [[nodiscard]] bool empty() const { return u.empty() && v.empty(); }
};

/// The same layout on finer knots, a wish per patch.
[[nodiscard]] Result<PatchLayout> refineLayout(const boundary::BoundaryLoop& loop,
                                               const PatchLayout& layout,
                                               const std::vector<KnotWish>& wishes);

}  // namespace fairing::layout
