// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/blend_options.h"

namespace fairing {

std::optional<Error> validate(const BlendOptions& options) {
  for (const std::size_t side : {std::size_t(0), std::size_t(1)})
    for (const double reach : {options.reach.at(side, 0.0), options.reach.at(side, 1.0)})
      if (!(reach > 0.0)) return Error{.code = ErrorCode::ReachNotPositive, .value = reach};
  return validate(options.fill);
}

}  // namespace fairing
