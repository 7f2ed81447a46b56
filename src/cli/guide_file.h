// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/energy/guidance.h"

namespace fairing::cli {

/// Reads {"normals": [{"point": [x,y,z], "normal": [x,y,z], "weight": w, "radius": r}, ...]};
/// weight may be left out (1), radius is in mm. Normals need not be of unit length. Fails with
/// FileUnreadable or GuideInvalid.
[[nodiscard]] Result<std::vector<energy::NormalHandle>> readGuide(const std::string& path);

}  // namespace fairing::cli
