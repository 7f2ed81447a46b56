// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <string>

#include "core/base/error.h"

namespace fairing::text {

/// The sentence on what is wrong with a blend; none for errors that are not about one.
[[nodiscard]] std::optional<std::string> blendErrorSentence(const Error& error);

}  // namespace fairing::text
