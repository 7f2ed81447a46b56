// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/blend_chains.h"

#include "core/blend/natural_strip.h"

// The pipeline (docs/ARCHITECTURE.md):
//
//   two chains -> ChainPair -> LayoutPlan (strip) -> spanPlan -> reach as the energy likes it? ->
//   done
//                                                                       | ^
//                                                                  held rows -> spanAgain
//                                                                  ---------+

namespace fairing {

std::optional<Error> validate(const BlendOptions& options) {
  for (const double reach : options.reach)
    if (!(reach > 0.0)) return Error{.code = ErrorCode::ReachNotPositive, .value = reach};
  return validate(options.fill);
}

Result<FillResult> blendChains(const boundary::ChainPair& pair,
                               const BlendOptions& options,
                               Progress* progress) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  const auto natural = NaturalStrip::make(pair, options.fill, progress);
  if (!natural) return fail(natural.error());
  return options.reach == Reach{1.0, 1.0} ? natural->result() : natural->reaching(options.reach);
}

}  // namespace fairing
