// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <optional>

#include "core/base/error.h"

namespace fairing::occt {

/// ResultInvalid with the first thing the kernel's check finds wrong, or nothing.
[[nodiscard]] std::optional<Error> checkShape(const TopoDS_Shape& shape);

}  // namespace fairing::occt
