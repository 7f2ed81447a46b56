// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/result.h"
#include "core/boundary/chain_ring.h"
#include "core/layout/layout_plan.h"

namespace fairing::layout {

// Between closed chains 0, 1, 2, ... in a ring run cuts, from e_i to s_i+1. They and the halves
// s_i -> e_i of the chains enclose the front, they and the halves e_i -> s_i the back; either is a
// star. The front of three:
//
//              e0 -- M0 -- s1
//             /       |      \            M  middles of the cuts
//           f0 .      |      . f1         f  middles of the halves
//           /     ` . | . '     \         F  centre
//          s0         F         e1        4N patches in all: two a half
//            \      ' | `      /
//            M2  '    |    `  M1
//              \      f2     /
//               e2 ------- s2
//
/// Cuts start and end where a chain reaches farthest towards its neighbours, but for those that are
/// set. `ring` is that of boundary::ringOfLoops(). Fails with CutUnfit (a cut between chains that
/// are no neighbours, or a second one), CutsTooClose and the codes of makeLoop().
[[nodiscard]] Result<LayoutPlan> junctionPlan(const boundary::ChainRing& ring);

}  // namespace fairing::layout
