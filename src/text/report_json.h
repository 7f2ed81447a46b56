// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "core/fill/fill_hole.h"

namespace fairing::text {

/// The same numbers for programs. Keys are snake_case, lengths mm, angles degrees, times seconds; a
/// number that is not finite becomes null.
[[nodiscard]] nlohmann::json toJson(const analysis::FillReport& report);
/// How well a guide is followed; "where" is null where no normal guides.
[[nodiscard]] nlohmann::json toJson(const analysis::GuidanceReport& guidance);
[[nodiscard]] nlohmann::json notesToJson(const std::vector<analysis::Note>& notes);
/// The report, and how the patches came about under "solve" and "patches".
[[nodiscard]] nlohmann::json toJson(const FillResult& result);

}  // namespace fairing::text
