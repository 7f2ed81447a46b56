// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "cli/commands.h"
#include "core/base/result.h"

namespace fairing::cli {

/// One line on stderr.
void complain(const std::string& sentence);
/// The error's sentence on stderr; returns Outcome::NothingWritten.
Outcome complain(const Error& error);

/// Writes JSON to a file that appears complete or not at all. Fails with FileUnwritable.
[[nodiscard]] Result<void> writeJson(const nlohmann::json& json, const std::string& path);
/// Whether a shape may be written to `out` and writeJson() to `report`, unless these are empty:
/// asked before any work is done.
[[nodiscard]] Result<void> checkOutputs(const std::string& out, const std::string& report);

}  // namespace fairing::cli
