// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>

#include "core/analysis/continuity_report.h"

namespace fairing::text {

/// One sentence about something the user should know that is no failure. No line breaks.
[[nodiscard]] std::string sentence(const analysis::Note& note);

}  // namespace fairing::text
