// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/constraint/inner_constraint.h"

namespace fairing::cli {

/// "x,y,z", or the name of a file: of a .brep or .step its edges and lone vertices, of any other
/// its points, one a line ("x y z" or "x, y, z"; blank lines and lines that start with # are left
/// out). Fails with the codes of readShape(), FileUnreadable, or UnknownChoice with the line that
/// is no point.
[[nodiscard]] Result<std::vector<InnerConstraint>> readThrough(const std::string& word);

}  // namespace fairing::cli
