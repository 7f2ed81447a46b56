// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>

#include "core/uniform_patch/control_net.h"

namespace fairing::kiciak {

/// A control net as text: the two numbers of control points along u and v, then x y z of each, one
/// a line, those of one u after the other. Fails with FileUnreadable or NetInvalid.
[[nodiscard]] Result<uniform_patch::ControlNet> readNet(const std::string& path);

/// The same text, every number with 17 digits, so that nothing is lost. Fails with FileUnwritable.
[[nodiscard]] Result<void> writeNet(const uniform_patch::ControlNet& net, const std::string& path);

}  // namespace fairing::kiciak
