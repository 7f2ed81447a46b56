// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/blend_chains.h"

#include <utility>

#include "core/blend/natural_strip.h"

// The pipeline (docs/ARCHITECTURE.md):
//
//   two chains -> ChainPair -> LayoutPlan (strip) -> spanPlan -> leaves as asked?
//     no: turnedRows -> spanAgain        reach not 1: scaledRows -> spanAgain

namespace fairing {

Result<Blend> blendChains(const boundary::ChainPair& pair,
                          const BlendOptions& options,
                          Progress* progress) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  auto made = NaturalStrip::make(pair, options, progress);
  if (!made) return fail(made.error());
  const auto natural = std::make_shared<const NaturalStrip>(std::move(*made));
  auto fill = natural->reaching(options.reach);
  if (!fill) return fail(fill.error());
  return Blend{std::move(*fill), natural};
}

}  // namespace fairing
