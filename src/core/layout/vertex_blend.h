// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/layout/layout_plan.h"

namespace fairing::layout {

// Open chains s_i -> e_i with gaps from e_i to s_i+1, which free edges cross:
//
//          e0 - - M0 - - s1
//         /       |       \           M  middles of the free edges
//       f0 .      |      . f1         f  middles of the chains
//       /     ` . | . '     \         F  centre
//      s0         F         e1        two patches a chain
//        `      ' | `      '
//         M2 '    |    ` M1           Where two chains touch in a corner, one patch lies in it, as
//           `     f2   '              in a star.
//            e2 ------- s2
//
/// One star between the chains of boundary::ringOfChains(). Free edges go straight on in their
/// middles. Fails with LayoutUnfit (a chain turns the wrong way in two places or more) and the
/// codes of makeOpenChains().
[[nodiscard]] Result<LayoutPlan> vertexBlendPlan(const boundary::BoundaryLoop& loop);

}  // namespace fairing::layout
