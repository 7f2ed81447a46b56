// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <string>

#include "core/analysis/continuity_report.h"

namespace fairing::text {

/// Whether a side was to be met tangentially at least.
[[nodiscard]] bool asksTangency(const analysis::SideReport& side);
/// Whether a side was to be met in curvature.
[[nodiscard]] bool asksCurvature(const analysis::SideReport& side);

/// What misses its limit by the largest factor - an edge, a seam or an inner constraint - in words:
/// which, by how much, where and why. No full stop. Nothing where nothing was measured.
[[nodiscard]] std::optional<std::string> worstMiss(const analysis::FillReport& report);

}  // namespace fairing::text
