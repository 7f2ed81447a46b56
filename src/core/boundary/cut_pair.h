// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/boundary/strip_match.h"

namespace fairing::boundary {

/// The sides of the patches of a strip: first those along the first chain, in its direction, then
/// those along the second one. Patch k lies between side k and side 2 n - 1 - k of n patches. A
/// side is run through at constant speed where it is made of several edges, is closed, or has more
/// than `mostPoles` control points. Fails with the codes of measureSides().
[[nodiscard]] Result<CutLoop> cutPair(const ChainPair& pair,
                                      const std::vector<StripCut>& cuts,
                                      int mostPoles);

}  // namespace fairing::boundary
