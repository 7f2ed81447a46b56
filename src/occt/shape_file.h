// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <string>

#include "core/base/result.h"

namespace fairing::occt {

/// Reads .brep, .brp, .step or .stp (by extension, any case). Fails with FileFormatUnknown,
/// FileUnreadable, FileNotAShape.
[[nodiscard]] Result<TopoDS_Shape> readShape(const std::string& path);

/// Writes one of the same formats. The file appears complete or not at all. Fails with
/// FileFormatUnknown, FileUnwritable.
[[nodiscard]] Result<void> writeShape(const TopoDS_Shape& shape, const std::string& path);

/// Whether writeShape() knows the extension and may write there: asked before any work is done.
[[nodiscard]] Result<void> checkWritable(const std::string& path);

}  // namespace fairing::occt
