// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>

#include "core/analysis/continuity_report.h"

namespace fairing::text {

/// One sentence in words and numbers: how well all edges are met, or which edge is missed most, by
/// how much, where and why.
[[nodiscard]] std::string verdict(const analysis::FillReport& report);

/// One line an edge under a head line, in columns; ends with a line break.
[[nodiscard]] std::string table(const analysis::FillReport& report);

}  // namespace fairing::text
