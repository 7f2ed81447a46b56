// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace fairing::occt {

/// A shape out of bytes: BREP text, or the binary of FreeCAD's exportBinary. Fails with
/// FileNotAShape.
[[nodiscard]] Result<TopoDS_Shape> shapeFromBytes(std::string_view bytes);

/// BREP text without triangulation, as FreeCAD's importBrepFromString reads it.
[[nodiscard]] Result<std::string> bytesFromShape(const TopoDS_Shape& shape);

}  // namespace fairing::occt
