// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <optional>

#include "core/base/result.h"
#include "core/blend/reach.h"
#include "core/boundary/departure.h"
#include "core/span/fill_options.h"

namespace fairing {

/// Everything a caller may choose about a blend.
struct BlendOptions {
  FillOptions fill = {};  ///< the layout is a strip or a junction, whatever it says
  Reach reach = {};
  std::array<boundary::Departure, 2> departure{};  ///< from the first chain and from the second
  std::array<boundary::Leaving, 2> leaving{};
};

/// The first thing wrong with the options, if any: ReachNotPositive or what validate() says of a
/// fill's.
[[nodiscard]] std::optional<Error> validate(const BlendOptions& options);

}  // namespace fairing
