// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/boundary/strip_match.h"

namespace fairing::boundary {

/// The sides of the patches of a strip: first those along the first chain, in its direction, then
/// those along the second one, behind either of them one side for an end that is not free. Patch k
/// of n lies between side k of the first chain and side n - 1 - k of the second one. A side is run
/// through at constant speed where it is made of several edges, is closed, or has more than
/// `mostPoles` control points. Fails with the codes of measureSides().
[[nodiscard]] Result<CutLoop> cutPair(const ChainPair& pair,
                                      const std::vector<StripCut>& cuts,
                                      int mostPoles);

}  // namespace fairing::boundary
