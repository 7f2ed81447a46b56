// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <BRepBuilderAPI_Sewing.hxx>
#include <map>
#include <string>
#include <vector>

#include "occt/join.h"

namespace fairing::occt {

/// Sides with a face beside them along which the new faces still end freely after sewing: the
/// edge's number, and the largest distance of the edge from the new faces' border, mm.
[[nodiscard]] std::map<int, double> freeSides(const std::vector<JoinPart>& parts,
                                              const BRepBuilderAPI_Sewing& sewing);

/// SewingOpen with all of them, "edge 7: 0.27 mm, edge 9: 0.31 mm" in its detail.
[[nodiscard]] Error sewingOpen(const std::map<int, double>& free);

}  // namespace fairing::occt
