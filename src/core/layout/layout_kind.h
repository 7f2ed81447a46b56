// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace fairing {

enum class LayoutKind {
  Auto,  ///< chosen from the loop
  Quad,  ///< one patch between four sides
};

}  // namespace fairing
