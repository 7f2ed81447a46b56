// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/layout/layout_plan.h"
#include "core/layout/patch_layout.h"

namespace fairing::layout {

/// TooManySides for more than 64, which no layout spans.
[[nodiscard]] std::optional<Error> tooManySides(const boundary::BoundaryLoop& loop);

/// Whether a side is no more than the width of a corner beside the hole: no patch can have it for
/// an edge and be fair.
[[nodiscard]] bool isTiny(const boundary::BoundarySide& side, double diagonal);

/// The kinds that suit a loop, the best one first, the next ones for the case that it falls short:
/// quad for four corners, star for three or more, o-grid for two or fewer; trimmed before these
/// where the loop is smooth but bends too sharply for a patch, or has a tiny side.
[[nodiscard]] std::vector<LayoutKind> suitableKinds(const boundary::BoundaryLoop& loop);

/// How a loop is spanned by a kind; the one list of the choices. Auto takes the first suitable
/// one that consists of patches. Fails
/// with TooManySides, and WrongSideCount or LayoutUnfit where the kind does not suit the loop.
[[nodiscard]] Result<LayoutPlan> planLayout(const boundary::BoundaryLoop& loop, LayoutKind kind);

struct LayoutOptions {
  int degree = 0;             ///< 0 = chosen from the sides
  double fitTolerance = 0.0;  ///< mm, for sides that are not polynomial
  int maxPoles = 10000;       ///< of all patches
};

/// The coarsest patches on which the sides can be written.
[[nodiscard]] PatchLayout makeLayout(const LayoutPlan& plan, const LayoutOptions& options);

struct CoarseOptions {
  double density = 3.0;       ///< spans over a length equal to the square root of the hole's area
  double fitTolerance = 0.0;  ///< mm, of the sides
  int mostPolesAlong = 14;    ///< where the sides ask for more knots than the density
};

/// Patches of the same degrees with as few spans as the options ask for.
[[nodiscard]] PatchLayout coarseLayout(const LayoutPlan& plan,
                                       const PatchLayout& layout,
                                       const CoarseOptions& options);

/// The same layout with the knots of another of the same plan added, degrees raised to the higher
/// ones.
[[nodiscard]] PatchLayout withKnotsOf(const LayoutPlan& plan,
                                      const PatchLayout& layout,
                                      const PatchLayout& other);

/// Knots to add to one patch, in its parameters.
struct KnotWish {
  std::vector<double> u, v;
  [[nodiscard]] bool empty() const { return u.empty() && v.empty(); }
};

/// The same layout on finer knots, a wish per patch; patches of one strip share them.
[[nodiscard]] PatchLayout refineLayout(const LayoutPlan& plan,
                                       const PatchLayout& layout,
                                       const std::vector<KnotWish>& wishes);

}  // namespace fairing::layout
