// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

namespace fairing::occt {

/// Every closed shell of a sewn shape becomes a solid of positive volume; one that lies within
/// another becomes a cavity of it. Open shells and faces stay what they are.
[[nodiscard]] TopoDS_Shape solidsWhereClosed(const TopoDS_Shape& sewn);

/// One shape as it is, several in a compound.
[[nodiscard]] TopoDS_Shape compoundOf(const std::vector<TopoDS_Shape>& shapes);

}  // namespace fairing::occt
