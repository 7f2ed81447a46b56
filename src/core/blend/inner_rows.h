// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>

#include "core/base/result.h"
#include "core/blend/reach.h"
#include "core/boundary/boundary_loop.h"
#include "core/layout/patch_layout.h"
#include "core/span/span_hole.h"

namespace fairing {

/// A strip of `patches` on `layout`, the first chain on their South edges, the second one on their
/// North edges; `sides` are those of the layout. The rows of control points next to its sides are
/// what tangency, reach and direction of departure are about: R_v . n = 0 is linear and homogeneous
/// in their differences to the outer rows.
struct StripRows {
  const boundary::BoundaryLoop& sides;
  const layout::PatchLayout& layout;
  const Patches& patches;
};

/// The inner rows at `reach` times their distance from the outer ones. One factor keeps tangency to
/// the last bit; one that varies along the side is met where tangency is collocated, so that this
/// stays exact, and between by interpolation. Towards an end of the strip that follows something it
/// fades to 1.
[[nodiscard]] HeldPoints scaledRows(const StripRows& strip, const Reach& reach);

/// Whether the strip leaves the first chain, and the second one, anywhere on the half of the
/// tangent plane it is not to.
[[nodiscard]] std::array<bool, 2> leavesAmiss(const StripRows& strip);

/// The inner rows, those of the chains in `turn` made to leave as asked: perpendicularly to the
/// edge or along the face's iso-curves where these are asked for, as far as they did on average.
/// Fails as scaledRows() does.
[[nodiscard]] Result<HeldPoints> turnedRows(const StripRows& strip, std::array<bool, 2> turn);

}  // namespace fairing
