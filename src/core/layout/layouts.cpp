// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/layouts.h"

#include <algorithm>
#include <cmath>

#include "core/layout/quad.h"

namespace fairing::layout {
namespace {

// The longest a direction may become before the patch is too large.
int mostPolesAlong(int maxPoles) {
  return std::max(8, static_cast<int>(std::sqrt(maxPoles)));
}

spline::KnotVector withKnots(spline::KnotVector knots, const std::vector<double>& added) {
  for (const double t : added) knots = knots.withKnot(t);
  return knots.mapped(0.0, 1.0);
}

}  // namespace

Result<PatchLayout> makeLayout(const boundary::BoundaryLoop& loop, const LayoutOptions& options) {
  switch (options.kind) {
    case LayoutKind::Auto:
    case LayoutKind::Quad:
    default:
      break;
  }
  if (loop.sides.size() != 4)
    return fail(
        {ErrorCode::WrongSideCount, 0, 0, std::nullopt, static_cast<double>(loop.sides.size())});
  return quadLayout(
      loop,
      chooseQuadKnots(
          loop, options.degree, options.fitTolerance, mostPolesAlong(options.maxPoles)));
}

Result<PatchLayout> refineLayout(const boundary::BoundaryLoop& loop,
                                 const PatchLayout& layout,
                                 const std::vector<KnotWish>& wishes) {
  switch (layout.kind) {
    case LayoutKind::Auto:
    case LayoutKind::Quad:
    default:
      break;
  }
  const LayoutPatch& patch = layout.patches.front();
  return quadLayout(loop,
                    {withKnots(patch.u, wishes.front().u), withKnots(patch.v, wishes.front().v)});
}

}  // namespace fairing::layout
