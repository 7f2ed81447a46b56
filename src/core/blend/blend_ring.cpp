// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/blend_ring.h"

#include <utility>

#include "core/blend/natural_ring.h"

namespace fairing {
namespace {

// What is asked that only a strip has.
std::optional<Error> wishOfStrip(const BlendOptions& options) {
  for (const std::size_t side : {std::size_t(0), std::size_t(1)}) {
    if (options.departure[side] != boundary::Departure::Free)
      return Error{.code = ErrorCode::JunctionWish, .detail = "direction of departure"};
    if (options.leaving[side] != boundary::Leaving::Onwards)
      return Error{.code = ErrorCode::JunctionWish, .detail = "flip"};
  }
  return std::nullopt;
}

}  // namespace

Result<Blend> blendRing(const boundary::ChainRing& ring,
                        const BlendOptions& options,
                        Progress* progress) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  if (const auto wish = wishOfStrip(options)) return fail(*wish);
  auto made = NaturalRing::make(ring, options, progress);
  if (!made) return fail(made.error());
  const auto natural = std::make_shared<const NaturalRing>(std::move(*made));
  auto fill = natural->reaching(options.reach);
  if (!fill) return fail(fill.error());
  return Blend{std::move(*fill), natural};
}

}  // namespace fairing
