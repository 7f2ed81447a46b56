// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <tl/expected.hpp>

#include "core/base/error.h"

namespace fairing {

/// A value or the reason why there is none.
template <class T>
using Result = tl::expected<T, Error>;

/// `return fail({ErrorCode::...})` in a function that returns a Result.
inline tl::unexpected<Error> fail(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

}  // namespace fairing
