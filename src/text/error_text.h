// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>

#include "core/base/error.h"

namespace fairing::text {

/// One sentence: what is wrong, with which edge, where, and what to do. No line breaks.
[[nodiscard]] std::string sentence(const Error& error);

}  // namespace fairing::text
