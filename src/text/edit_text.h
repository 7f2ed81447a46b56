// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "core/edit/edit_surface.h"

namespace fairing::text {

/// What an edit did, in one sentence.
[[nodiscard]] std::string verdict(const EditReport& report);

/// The sentence; how well the guide is followed before and after, the energies, what moved; and a
/// line a note. Ends with a line break.
[[nodiscard]] std::string table(const EditReport& report);

/// The same numbers for programs. Lengths mm, angles degrees, energies mm^2.
[[nodiscard]] nlohmann::json toJson(const EditResult& edit);

}  // namespace fairing::text
