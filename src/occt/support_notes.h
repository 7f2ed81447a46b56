// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/analysis/continuity_report.h"
#include "core/boundary/boundary_loop.h"

namespace fairing::occt {

/// Adds a note for every side that is to be met tangentially and whose face has no normal
/// somewhere.
void addSingularSupports(const boundary::BoundaryLoop& loop, analysis::FillReport& report);

}  // namespace fairing::occt
