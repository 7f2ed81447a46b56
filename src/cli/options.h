// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/tolerance.h"
#include "core/boundary/continuity.h"
#include "occt/result_mode.h"

namespace fairing::cli {

/// What several commands have in common.

/// An option that takes a list with commas, once.
void addList(CLI::App& command, const char* name, std::vector<std::string>& list, const char* help);

/// "7=G0" by edge number. Fails with UnknownChoice.
[[nodiscard]] Result<std::map<int, Continuity>> continuityWishes(
    const std::vector<std::string>& words);

/// Zero is no tolerance, whatever it means elsewhere. Fails with ToleranceNotPositive.
[[nodiscard]] Result<Tolerance> toleranceFrom(std::optional<double> gap,
                                              std::optional<double> angle);

/// Fails with UnknownChoice.
[[nodiscard]] Result<occt::ResultMode> modeFrom(const std::string& word);

}  // namespace fairing::cli
