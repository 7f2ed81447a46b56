// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/guide_live.h"

#include <utility>

namespace fairing::occt {
Result<ShapeFill> guiding(const ShapeFill& before, const energy::Guidance& guidance, bool lookUp) {
  auto fill = before.live->under(guidance, lookUp);
  if (!fill) return tl::unexpected(fill.error());
  return preview(before, std::move(*fill));
}

Result<ShapeBlend> guiding(const ShapeBlend& before,
                           const energy::Guidance& guidance,
                           bool lookUp) {
  auto guided = before.live->under(guidance, lookUp);
  if (!guided) return tl::unexpected(guided.error());
  guided->matches = before.fill.matches;
  const auto natural = before.natural->guided(guidance, std::move(*guided));
  auto fill = natural->reaching(before.reach);
  if (!fill) return tl::unexpected(fill.error());
  return ShapeBlend{preview(before, std::move(*fill)), natural, before.reach};
}

}  // namespace fairing::occt
